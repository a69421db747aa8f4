// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/recording_model.h"

class QPushButton;

namespace glisson::ui {

/// Says how the recording goes. Its button is shown elsewhere, beside what plays.
class RecordingBox : public QWidget {
  Q_OBJECT
 public:
  /// @param model outlives the box.
  explicit RecordingBox(RecordingModel& model, QWidget* parent = nullptr);

  /// Starts and stops; belongs to the box until it is put somewhere.
  QPushButton* button() const { return button_; }

 private:
  /// Starts with a file that the person names, or stops.
  void toggle();

  RecordingModel& model_;
  QPushButton* button_;
  Couplings couplings_;
};

}  // namespace glisson::ui
