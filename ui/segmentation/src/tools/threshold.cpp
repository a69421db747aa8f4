// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <algorithm>

#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {
namespace {

// The ends push each other, so that the range is never empty. Whole numbers do: the first digit of one that
// is being typed would push the other end away.
const PageField::Range kRange = {-2000.0, 5000.0, 5.0, 0, "HU"};

PageField low_end() {
  PageField field = number_box("threshold_low", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "From"), kRange,
                               &EditSettings::low);
  field.whole_numbers = true;
  field.set = [](EditSettings& s, double value) {
    s.low = value;
    s.high = std::max(s.high, value);
  };
  return field;
}

PageField high_end() {
  PageField field = number_box("threshold_high", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "To"), kRange,
                               &EditSettings::high);
  field.whole_numbers = true;
  field.set = [](EditSettings& s, double value) {
    s.high = value;
    s.low = std::min(s.low, value);
  };
  return field;
}

PageField mask_button() {
  PageField button;
  button.kind = PageField::Kind::button;
  button.object = "threshold_mask";
  button.text = QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Use the range for painting");
  button.tip = QT_TRANSLATE_NOOP("glisson::ui::ToolPages",
                                 "Tools then change only voxels of these intensities; paint comes next.");
  button.set = [](EditSettings& s, double) { s.region.intensity = {s.low, s.high}; };
  button.then = "paint";
  return button;
}

}  // namespace

const WindowTool& threshold_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{"threshold",
                    'T',
                    QT_TRANSLATE_NOOP("EditTexts", "Threshold"),
                    {{"threshold", QT_TRANSLATE_NOOP("EditTexts", "Threshold")}},
                    [](const EditSettings&) {
                      return QT_TRANSLATE_NOOP("EditTexts",
                                               "Everything between two intensities becomes the label.");
                    },
                    "everything between two intensities. *Use the range for painting* lets the brush change "
                    "only such voxels: the quickest way along a vessel"};
    tool.page = {low_end(), high_end(),
                 check_box("threshold_replace",
                           QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Forget what the label had before"),
                           &EditSettings::replace),
                 mask_button()};
    tool.whole = [](const EditSettings& s, const WholeVolume&) {
      return editing::Threshold{s.label, s.low, s.high, s.replace};
    };
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
