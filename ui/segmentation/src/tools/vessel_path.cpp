// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/vessel_path.h"

#include <QCoreApplication>

#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {

const WindowTool& vessel_path_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{
        "vessel_path",
        140,
        'V',
        QT_TRANSLATE_NOOP("EditTexts", "Vessel path"),
        {{"vessel_path", QT_TRANSLATE_NOOP("EditTexts", "Vessel path")}},
        [](const EditSettings& s) {
          const bool is_vessel = s.label == structure::kPortalVein || s.label == structure::kHepaticVeins ||
                                 s.label == structure::kVenaCava || s.label == structure::kArtery;
          return is_vessel ? QT_TRANSLATE_NOOP("EditTexts",
                                               "Click the two ends of a missing piece of vessel. Ctrl adds a "
                                               "point between.")
                           : QT_TRANSLATE_NOOP("EditTexts",
                                               "First choose a vessel in the list of labels: portal vein, "
                                               "hepatic veins, vena cava or artery.");
        },
        "click the two ends of a gap in a vessel: the cheapest way through the CT between them becomes a "
        "tube "
        "of the chosen label, as wide as the CT shows it. It takes background and parenchyma only. After the "
        "first click, what a second one would make is hatched under the pointer. Ctrl adds a point between, "
        "Esc drops the clicks"};
    tool.page = {number_box("path_largest", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Radius at most"),
                            range_of("vessel_path", "largest_radius_mm", 0.5, 0.5, 1),
                            &editing::VesselPath::largest_radius, 1e3)};
    tool.hand = [](const EditSettings&) { return Hand::point; };
    tool.at_pointer = WindowTool::AtPointer::way;
    tool.chain = [](const EditSettings& s, const Points& path) {
      auto way = s.of<editing::VesselPath>();
      way.label = s.label;
      way.path = path;
      return way;
    };
    tool.foretells = [](const editing::Tool&) -> Foretold {
      return {QT_TRANSLATE_NOOP("EditTexts", "A click here makes a vessel of %1 ml.")};
    };
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
