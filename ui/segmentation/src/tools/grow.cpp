// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "glisson/editing/tools/grow.h"
#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {
namespace {

std::vector<Label> growing(const EditSettings& s, const std::vector<Label>& present) {
  std::vector<Label> labels;
  for (const Label label : present)
    if (!is_other(label) && !is_among(s.region.locked, label)) labels.push_back(label);
  return labels;
}

}  // namespace

const WindowTool& grow_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{"grow",
                    50,
                    'G',
                    QT_TRANSLATE_NOOP("EditTexts", "Grow from seeds"),
                    {{"grow_from_seeds", QT_TRANSLATE_NOOP("EditTexts", "Grow from seeds")}},
                    [](const EditSettings&) {
                      return QT_TRANSLATE_NOOP("EditTexts",
                                               "What is labelled grows into what is not, along like "
                                               "intensities. Paint a few strokes of each label first.");
                    },
                    "paint a stroke or two of each label, then let them grow into what is not labelled, "
                    "along like intensities"};
    tool.page = {number_box("grow_reach", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "No farther than"),
                            range_of("grow_from_seeds", "reach_mm", 1.0, 1.0, 0),
                            &editing::GrowFromSeeds::reach, 1e3)};
    tool.is_slow = true;
    tool.works_on_label = [](const EditSettings&) { return false; };
    tool.obstacle = [](const EditSettings& s, const std::vector<Label>& present) {
      return growing(s, present).size() < 2 ? EditObstacle::one_label : EditObstacle::none;
    };
    tool.whole = [](const EditSettings& s, const WholeVolume& volume) {
      auto grow = s.of<editing::GrowFromSeeds>();
      grow.labels = growing(s, volume.present);
      for (const Label label : volume.present)
        if (is_other(label)) grow.rivals.push_back(label);
      return grow;
    };
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
