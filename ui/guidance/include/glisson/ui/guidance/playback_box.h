// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/playback_model.h"

class QHBoxLayout;

namespace glisson::ui {

/// Starts, stops and repeats the tracking of the case's video.
class PlaybackBox : public QWidget {
  Q_OBJECT
 public:
  /// @param model outlives the box.
  PlaybackBox(EngineBridge& engine, PlaybackModel& model, QWidget* parent = nullptr);

  /// Puts a control of what goes with the playing next to the Stop button.
  void add_beside_stop(QWidget* control);

 private:
  QHBoxLayout* row_;
  Couplings couplings_;
};

}  // namespace glisson::ui
