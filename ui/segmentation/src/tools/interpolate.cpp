// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {

const WindowTool& interpolate_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{"interpolate",
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
                            &EditSettings::between)};
    tool.obstacle = empty_label;
    tool.whole = [](const EditSettings& s, const WholeVolume& volume) {
      return editing::InterpolateSlices{s.label, voxel_axis_across(volume.grid, s.between)};
    };
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
