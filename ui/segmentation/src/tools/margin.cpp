// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {

const WindowTool& margin_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{"margin",
                    'M',
                    QT_TRANSLATE_NOOP("EditTexts", "Margin"),
                    {{"margin.grow", QT_TRANSLATE_NOOP("EditTexts", "Margin: grow")},
                     {"margin.shrink", QT_TRANSLATE_NOOP("EditTexts", "Margin: shrink")}},
                    [](const EditSettings&) {
                      return QT_TRANSLATE_NOOP("EditTexts", "Grows or shrinks the label by a distance.");
                    },
                    "grows or shrinks by a distance in millimetres"};
    tool.page = {choice_box("margin_direction", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Does"),
                            {QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Grow"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Shrink")},
                            &EditSettings::shrink),
                 number_box("margin_distance", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "By"),
                            range_of("margin", "distance_mm", 0.5, 0.5, 1), &EditSettings::margin, 1e3)};
    tool.obstacle = empty_label;
    tool.whole = [](const EditSettings& s, const WholeVolume&) {
      return editing::Margin{s.label, s.shrink ? -s.margin : s.margin};
    };
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
