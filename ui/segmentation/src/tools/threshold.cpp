// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <algorithm>

#include "glisson/editing/tools/threshold.h"
#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {
namespace {

using editing::Threshold;

// The ends push each other, so that the range is never empty. Whole numbers do: the first digit of one that
// is being typed would push the other end away.
const PageField::Range kRange = {-2000.0, 5000.0, 5.0, 0, "HU"};

PageField low_end() {
  PageField field = number_box("threshold_low", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "From"), kRange,
                               &Threshold::low);
  field.whole_numbers = true;
  field.set = [](EditSettings& s, double value) {
    auto& range = s.of<Threshold>();
    range.low = value;
    range.high = std::max(range.high, value);
  };
  return field;
}

PageField high_end() {
  PageField field = number_box("threshold_high", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "To"), kRange,
                               &Threshold::high);
  field.whole_numbers = true;
  field.set = [](EditSettings& s, double value) {
    auto& range = s.of<Threshold>();
    range.high = value;
    range.low = std::min(range.low, value);
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
  button.set = [](EditSettings& s, double) {
    const auto& range = s.of<Threshold>();
    s.region.intensity = {range.low, range.high};
  };
  button.then = "paint";
  return button;
}

}  // namespace

const WindowTool& threshold_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{"threshold",
                    40,
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
                           &Threshold::replace),
                 mask_button()};
    tool.whole = [](const EditSettings& s, const WholeVolume&) {
      auto threshold = s.of<Threshold>();
      threshold.label = s.label;
      return threshold;
    };
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
