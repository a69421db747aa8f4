// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {

const WindowTool& erase_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{"erase",
                    20,
                    'E',
                    QT_TRANSLATE_NOOP("EditTexts", "Erase"),
                    {{"erase", QT_TRANSLATE_NOOP("EditTexts", "Erase")}},
                    [](const EditSettings&) {
                      return QT_TRANSLATE_NOOP("EditTexts",
                                               "Drag in a slice. Ctrl paints. Shift + wheel: size.");
                    },
                    ""};
    tool.hand = [](const EditSettings&) { return Hand::brush; };
    tool.erases = true;
    tool.page_of = "paint";
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
