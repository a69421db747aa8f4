// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/tool_model.h"

namespace glisson::ui {

/// The switch for a tracked tool, where its pose comes from, and how far its tip is from what matters.
class ToolBox : public QWidget {
  Q_OBJECT
 public:
  /// @param model outlives the box.
  explicit ToolBox(ToolModel& model, QWidget* parent = nullptr);

 private:
  Couplings couplings_;
};

}  // namespace glisson::ui
