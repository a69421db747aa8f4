// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "glisson/editing/tools/scissors.h"
#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {

const WindowTool& scissors_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{
        "scissors",
        30,
        'X',
        QT_TRANSLATE_NOOP("EditTexts", "Scissors"),
        {{"scissors.fill_inside", QT_TRANSLATE_NOOP("EditTexts", "Scissors: fill inside")},
         {"scissors.erase_inside", QT_TRANSLATE_NOOP("EditTexts", "Scissors: erase inside")},
         {"scissors.erase_outside", QT_TRANSLATE_NOOP("EditTexts", "Scissors: erase outside")}},
        [](const EditSettings&) {
          return QT_TRANSLATE_NOOP(
              "EditTexts",
              "Draw around it, in a slice or in 3D. Ctrl fills instead of erasing, and the other way.");
        },
        "draw a line around what is to go (or, *Erase outside*, to stay; or *Fill inside*). In a slice it "
        "cuts that slice, a slab around it or the whole volume; in the 3D view as deep as the volume. Ctrl "
        "fills instead of erasing"};
    tool.hand = [](const EditSettings&) { return Hand::lasso; };
    tool.page = {choice_box("scissors_operation", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Does"),
                            {QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Fill inside"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Erase inside"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Erase outside")},
                            &editing::Scissors::operation),
                 choice_box("scissors_depth", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "In slices"),
                            {QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "This slice only"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "A slab around it"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Through the whole volume")},
                            &Cut::depth),
                 number_box("scissors_slab", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Slab"),
                            {1.0, 200.0, 1.0, 0, "mm"}, &Cut::slab, 1e3),
                 check_box("scissors_any", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Erase any label"),
                           &Cut::any_label)};
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
