// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <cmath>

#include "glisson/editing/tools/margin.h"
#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {
namespace {

using editing::Margin;

// The distance's sign says which way; the page asks for the two apart.
PageField direction() {
  PageField field = choice_box("margin_direction", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Does"),
                               {QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Grow"),
                                QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Shrink")},
                               &Margin::distance);
  field.get = [](const EditSettings& s) { return s.of<Margin>().distance < 0.0 ? 1.0 : 0.0; };
  field.set = [](EditSettings& s, double shrinks) {
    double& distance = s.of<Margin>().distance;
    distance = std::copysign(distance, shrinks == 0.0 ? 1.0 : -1.0);
  };
  return field;
}

PageField distance() {
  PageField field = number_box("margin_distance", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "By"),
                               range_of("margin", "distance_mm", 0.5, 0.5, 1), &Margin::distance, 1e3);
  field.get = [](const EditSettings& s) { return 1e3 * std::abs(s.of<Margin>().distance); };
  field.set = [](EditSettings& s, double value) {
    double& distance = s.of<Margin>().distance;
    distance = std::copysign(value / 1e3, distance);
  };
  return field;
}

}  // namespace

const WindowTool& margin_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{"margin",
                    100,
                    'M',
                    QT_TRANSLATE_NOOP("EditTexts", "Margin"),
                    {{"margin.grow", QT_TRANSLATE_NOOP("EditTexts", "Margin: grow")},
                     {"margin.shrink", QT_TRANSLATE_NOOP("EditTexts", "Margin: shrink")}},
                    [](const EditSettings&) {
                      return QT_TRANSLATE_NOOP("EditTexts", "Grows or shrinks the label by a distance.");
                    },
                    "grows or shrinks by a distance in millimetres"};
    tool.page = {direction(), distance()};
    tool.obstacle = empty_label;
    tool.whole = [](const EditSettings& s, const WholeVolume&) {
      auto margin = s.of<Margin>();
      margin.label = s.label;
      return margin;
    };
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
