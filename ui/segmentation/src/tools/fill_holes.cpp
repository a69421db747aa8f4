// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "glisson/editing/tools/fill_holes.h"
#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {

const WindowTool& fill_holes_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{
        "fill_holes",
        80,
        'F',
        QT_TRANSLATE_NOOP("EditTexts", "Fill holes"),
        {{"fill_holes", QT_TRANSLATE_NOOP("EditTexts", "Fill holes")}},
        [](const EditSettings&) { return QT_TRANSLATE_NOOP("EditTexts", "Closes what the label encloses."); },
        "what a label encloses; on request also what it encloses in one slice"};
    tool.page = {check_box("holes_in_slices",
                           QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Holes of one slice, too"),
                           &editing::FillHoles::in_slices)};
    tool.obstacle = empty_label;
    tool.whole = [](const EditSettings& s, const WholeVolume&) {
      auto fill = s.of<editing::FillHoles>();
      fill.label = s.label;
      return fill;
    };
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
