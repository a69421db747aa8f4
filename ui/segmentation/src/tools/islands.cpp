// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "glisson/editing/tools/islands.h"
#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {
namespace {

using editing::Islands;

Islands set_up(const EditSettings& s) {
  auto islands = s.of<Islands>();
  islands.label = s.label;
  return islands;
}

bool by_click(const EditSettings& s) {
  const auto operation = s.of<Islands>().operation;
  return operation == Islands::Operation::keep_clicked || operation == Islands::Operation::remove_clicked;
}

}  // namespace

const WindowTool& islands_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{"islands",
                    70,
                    'I',
                    QT_TRANSLATE_NOOP("EditTexts", "Islands"),
                    {{"islands.keep_largest", QT_TRANSLATE_NOOP("EditTexts", "Islands: keep largest")},
                     {"islands.remove_small", QT_TRANSLATE_NOOP("EditTexts", "Islands: remove small")},
                     {"islands.keep_clicked", QT_TRANSLATE_NOOP("EditTexts", "Islands: keep clicked")},
                     {"islands.remove_clicked", QT_TRANSLATE_NOOP("EditTexts", "Islands: remove clicked")},
                     {"islands.split", QT_TRANSLATE_NOOP("EditTexts", "Islands: split")}},
                    [](const EditSettings& s) {
                      return by_click(s)
                                 ? QT_TRANSLATE_NOOP("EditTexts",
                                                     "Click an island of the label. Ctrl does the opposite.")
                                 : QT_TRANSLATE_NOOP("EditTexts", "Separate pieces of the label.");
                    },
                    "keep the largest piece, remove small ones, keep or remove the one that you click, or "
                    "give each a label of its own"};
    tool.page = {choice_box("islands_operation", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Does"),
                            {QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Keep the largest"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Remove small ones"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Keep the one that is clicked"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Remove the one that is clicked"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Split: a label for each")},
                            &Islands::operation),
                 number_box("islands_smallest", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Smaller than"),
                            {0.01, 100.0, 0.1, 2, "ml"}, &Islands::smallest_ml)};
    tool.hand = [](const EditSettings& s) { return by_click(s) ? Hand::point : Hand::crosshair; };
    tool.obstacle = empty_label;
    tool.click = [](const EditSettings& s, const ToolClick& at) {
      Islands islands = set_up(s);
      islands.p_in_ct = at.p.xyz;
      if (at.invert)
        islands.operation = islands.operation == Islands::Operation::keep_clicked
                                ? Islands::Operation::remove_clicked
                                : Islands::Operation::keep_clicked;
      return islands;
    };
    tool.whole = [](const EditSettings& s, const WholeVolume&) { return set_up(s); };
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
