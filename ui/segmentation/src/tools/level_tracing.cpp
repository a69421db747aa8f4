// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "glisson/editing/tools/level_tracing.h"
#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {

const WindowTool& level_tracing_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{
        "level_tracing",
        60,
        'L',
        QT_TRANSLATE_NOOP("EditTexts", "Level tracing"),
        {{"level_tracing", QT_TRANSLATE_NOOP("EditTexts", "Level tracing")},
         {"level_tracing.erase", QT_TRANSLATE_NOOP("EditTexts", "Level tracing: erase")}},
        [](const EditSettings&) {
          return QT_TRANSLATE_NOOP("EditTexts",
                                   "Click where the region of like intensity ends. Ctrl erases.");
        },
        "the outline at the pointer is what a click takes: the region of like intensity that is enclosed "
        "there, in that slice. Move along an edge until it fits. Dashed: the region runs out of the slice"};
    tool.hand = [](const EditSettings&) { return Hand::point; };
    tool.at_pointer = WindowTool::AtPointer::outline;
    tool.click = [](const EditSettings& s, const ToolClick& at) {
      return editing::LevelTracing{s.label, at.invert, voxel_axis_across(at.grid, at.plane), at.p.xyz};
    };
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
