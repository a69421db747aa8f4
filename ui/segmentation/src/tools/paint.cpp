// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <cmath>

#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {
namespace {

constexpr double kMm = 1e3;  ///< millimetres in a metre
/// The brush's slider is logarithmic: a vessel's width and a lobe's are both a small move away.
constexpr int kSliderSteps = 200;

PageField brush_slider() {
  PageField slider;
  slider.kind = PageField::Kind::slider;
  slider.object = "brush_slider";
  slider.tip = QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Size of the brush. In a slice: Shift + wheel.");
  slider.range = {0.0, kSliderSteps, 1.0, 0};
  slider.get = [](const EditSettings& s) {
    return std::round(kSliderSteps * std::log(s.brush_radius / kSmallestBrush) /
                      std::log(kLargestBrush / kSmallestBrush));
  };
  slider.set = [](EditSettings& s, double value) {
    const double radius = kSmallestBrush * std::pow(kLargestBrush / kSmallestBrush, value / kSliderSteps);
    s.brush_radius = 5e-5 * std::round(2e4 * radius);
  };
  return slider;
}

}  // namespace

const WindowTool& paint_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{"paint",
                    10,
                    'P',
                    QT_TRANSLATE_NOOP("EditTexts", "Paint"),
                    {{"paint", QT_TRANSLATE_NOOP("EditTexts", "Paint")}},
                    [](const EditSettings&) {
                      return QT_TRANSLATE_NOOP("EditTexts",
                                               "Drag in a slice. Ctrl erases. Shift + wheel: size.");
                    },
                    "drag. Ctrl does the other of the two. The circle is the brush in its true size, in all "
                    "slices; Shift + wheel, slider or number sizes it. A *disc* stays in its slice, a *ball* "
                    "reaches into the next ones"};
    tool.hand = [](const EditSettings&) { return Hand::brush; };
    tool.page = {number_box("brush_diameter", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Diameter"),
                            {2.0 * kMm * kSmallestBrush, 2.0 * kMm * kLargestBrush, 1.0, 1, "mm"},
                            &EditSettings::brush_radius, 2.0 * kMm),
                 brush_slider(),
                 choice_box("brush_shape", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Brush"),
                            {QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Disc, this slice"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Ball, all slices")},
                            &EditSettings::ball),
                 check_box("erase_any", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Erase any label"),
                           &EditSettings::erase_any)};
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
