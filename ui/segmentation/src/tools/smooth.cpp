// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "glisson/editing/tools/smooth.h"
#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {
namespace {

using editing::Smooth;

bool is_joint(const EditSettings& s) { return s.of<Smooth>().method == Smooth::Method::joint; }

}  // namespace

const WindowTool& smooth_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{
        "smooth",
        90,
        'S',
        QT_TRANSLATE_NOOP("EditTexts", "Smooth"),
        {{"smooth.median", QT_TRANSLATE_NOOP("EditTexts", "Smooth: median")},
         {"smooth.closing", QT_TRANSLATE_NOOP("EditTexts", "Smooth: closing")},
         {"smooth.opening", QT_TRANSLATE_NOOP("EditTexts", "Smooth: opening")},
         {"smooth.joint", QT_TRANSLATE_NOOP("EditTexts", "Smooth: joint")}},
        [](const EditSettings& s) {
          return is_joint(s) ? QT_TRANSLATE_NOOP(
                                   "EditTexts",
                                   "All labels at once, without gaps between them; each keeps its volume.")
                             : QT_TRANSLATE_NOOP("EditTexts", "Evens the label's surface.");
        },
        "median, closing (fills gaps), opening (takes spikes), or all labels together without "
        "gaps between them, each with its volume and its thin branches"};
    tool.page = {choice_box("smooth_method", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Method"),
                            {QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Median"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Closing: fills gaps"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Opening: takes spikes"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Joint: all labels")},
                            &Smooth::method),
                 number_box("smooth_radius", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Radius"),
                            range_of("smooth", "radius_mm", 0.5, 0.5, 1), &Smooth::radius, 1e3)};
    tool.works_on_label = [](const EditSettings& s) { return !is_joint(s); };
    tool.obstacle = [](const EditSettings& s, const std::vector<Label>& present) {
      return is_joint(s) ? EditObstacle::none : empty_label(s, present);
    };
    tool.whole = [](const EditSettings& s, const WholeVolume&) {
      auto smooth = s.of<Smooth>();
      smooth.label = s.label;
      return smooth;
    };
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
