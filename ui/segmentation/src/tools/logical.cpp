// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "glisson/editing/tools/logical.h"
#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {
namespace {

using editing::Logical;
using Operation = Logical::Operation;

/// The label that is chosen, also while the operation asks for none.
struct Second {
  Label label = structure::kPortalVein;
  bool operator==(const Second&) const = default;
};

/// Whether it asks for no second label.
bool is_alone(Operation operation) {
  return operation == Operation::invert || operation == Operation::clear || operation == Operation::fill;
}

EditObstacle obstacle(const EditSettings& s, const std::vector<Label>& present) {
  const Operation operation = s.of<Logical>().operation;
  if (operation == Operation::invert || operation == Operation::fill) return EditObstacle::none;
  if (operation == Operation::clear) return empty_label(s, present);
  const Label second = s.of<Second>().label;
  if (second == s.label) return EditObstacle::same_label;
  if (!is_among(present, second)) return EditObstacle::other_empty;
  const bool gains = operation == Operation::copy || operation == Operation::add;
  return gains ? EditObstacle::none : empty_label(s, present);
}

PageField other_label() {
  PageField field = coupled(&Second::label);
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
        120,
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
                            &Logical::operation),
                 other_label()};
    tool.obstacle = obstacle;
    tool.whole = [](const EditSettings& s, const WholeVolume&) {
      auto logical = s.of<Logical>();
      logical.label = s.label;
      if (!is_alone(logical.operation)) logical.other = s.of<Second>().label;
      return logical;
    };
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
