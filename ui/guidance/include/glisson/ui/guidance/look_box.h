// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/guidance/live_view_model.h"

namespace glisson::ui {

/// What of the model is drawn, and how strongly.
class LookBox : public QWidget {
  Q_OBJECT
 public:
  /// @param model outlives the box.
  explicit LookBox(LiveViewModel& model, QWidget* parent = nullptr);
};

}  // namespace glisson::ui
