// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "glisson/ui/segmentation/edit_tools.h"

namespace glisson::ui {

QString tool_text(EditTool tool);
/// What to do with the mouse, in one line.
QString tool_hint(EditTool tool, const EditSettings& settings);
/// What a click would do: WindowTool::foretells. @param ml the volume that changes. Empty: it says nothing.
QString foretold_text(EditTool tool, const editing::Tool& click, const QString& ml);
/// Empty: none, or one that the engine names.
QString obstacle_text(EditObstacle obstacle);
QString review_text(ReviewState state);
/// A step of the history: "Paint, 10 mm, Portal vein" (the brush's diameter).
QString step_text(const editing::StepName& step, const EditTools& tools = edit_tools());
/// Whether a step of this code has a word of its own.
bool knows_step(const std::string& code);

}  // namespace glisson::ui
