// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/review_model.h"

namespace glisson::ui {

/// Below the picture: play, pause, step, seek, speed, loop, and back to the live video. Its keys are space,
/// left and right (with Shift ten frames), Home and End.
class TimelineBar : public QWidget {
  Q_OBJECT
 public:
  /// @param model outlives the bar.
  explicit TimelineBar(ReviewModel& model, QWidget* parent = nullptr);

  /// Puts a control of what goes with the picture at the right end.
  void add_at_end(QWidget* control);
  /// @return whether it is one of its keys, and done.
  bool press(int key, Qt::KeyboardModifiers modifiers);

 private:
  ReviewModel& model_;
  Couplings couplings_;
};

}  // namespace glisson::ui
