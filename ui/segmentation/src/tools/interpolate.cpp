// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "glisson/editing/tools/interpolate.h"
#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {
namespace {

/// Between which slices.
struct Between {
  scene::Plane plane = scene::Plane::axial;
  bool operator==(const Between&) const = default;
};

}  // namespace

const WindowTool& interpolate_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{"interpolate",
                    110,
                    'N',
                    QT_TRANSLATE_NOOP("EditTexts", "Interpolate between slices"),
                    {{"interpolate_slices", QT_TRANSLATE_NOOP("EditTexts", "Interpolate between slices")}},
                    [](const EditSettings&) {
                      return QT_TRANSLATE_NOOP("EditTexts",
                                               "Paint the label in some slices; those between are filled.");
                    },
                    "paint every fifth slice or so: those between are filled"};
    tool.page = {choice_box("interpolate_plane", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Slices"),
                            {QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Axial"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Coronal"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "Sagittal")},
                            &Between::plane)};
    tool.obstacle = empty_label;
    tool.whole = [](const EditSettings& s, const WholeVolume& volume) {
      return editing::InterpolateSlices{s.label, voxel_axis_across(volume.grid, s.of<Between>().plane)};
    };
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
