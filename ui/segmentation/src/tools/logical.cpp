// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {
namespace {

using Operation = editing::Logical::Operation;

/// Whether it asks for no second label.
bool is_alone(const EditSettings& s) {
  return s.logical == Operation::invert || s.logical == Operation::clear || s.logical == Operation::fill;
}

EditObstacle obstacle(const EditSettings& s, const std::vector<Label>& present) {
  if (s.logical == Operation::invert || s.logical == Operation::fill) return EditObstacle::none;
  if (s.logical == Operation::clear) return empty_label(s, present);
  if (s.other == s.label) return EditObstacle::same_label;
  if (!is_among(present, s.other)) return EditObstacle::other_empty;
  const bool gains = s.logical == Operation::copy || s.logical == Operation::add;
  return gains ? EditObstacle::none : empty_label(s, present);
}

PageField other_label() {
  PageField field = coupled(&EditSettings::other);
  field.kind = PageField::Kind::label;
  field.object = "logical_other";
  field.text = QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Other label");
  return field;
}

}  // namespace

const WindowTool& logical_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{
        "logical",
        'O',
        QT_TRANSLATE_NOOP("EditTexts", "Logical"),
        {{"logical.copy", QT_TRANSLATE_NOOP("EditTexts", "Logical: copy")},
         {"logical.add", QT_TRANSLATE_NOOP("EditTexts", "Logical: add")},
         {"logical.subtract", QT_TRANSLATE_NOOP("EditTexts", "Logical: subtract")},
         {"logical.intersect", QT_TRANSLATE_NOOP("EditTexts", "Logical: intersect")},
         {"logical.invert", QT_TRANSLATE_NOOP("EditTexts", "Logical: invert")},
         {"logical.clear", QT_TRANSLATE_NOOP("EditTexts", "Logical: clear")},
         {"logical.fill", QT_TRANSLATE_NOOP("EditTexts", "Logical: fill")}},
        [](const EditSettings&) { return QT_TRANSLATE_NOOP("EditTexts", "Combines two labels."); },
        "copy, add, subtract, intersect, invert, clear"};
    tool.page = {choice_box("logical_operation", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Does"),
                            {QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Copy from"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Add"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Subtract"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Keep what is also in"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Invert"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Clear"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Fill everything")},
                            &EditSettings::logical),
                 other_label()};
    tool.obstacle = obstacle;
    tool.whole = [](const EditSettings& s, const WholeVolume&) {
      return editing::Logical{s.label, s.logical, is_alone(s) ? structure::kBackground : s.other};
    };
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
