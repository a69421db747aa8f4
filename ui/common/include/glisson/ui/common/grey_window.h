// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>

#include "glisson/volume/image.h"

namespace glisson::ui {

/// Which greys a slice shows: those from level - width / 2 to level + width / 2, in the image's units.
struct GreyWindow {
  double level = 80.0, width = 400.0;
  bool operator==(const GreyWindow&) const = default;
};

/// Windows that have a name.
enum class WindowPreset { abdomen, liver, vessels, lung, bone, own, whole };
constexpr std::array<WindowPreset, 7> kWindowPresets = {
    WindowPreset::abdomen, WindowPreset::liver, WindowPreset::vessels, WindowPreset::lung,
    WindowPreset::bone,    WindowPreset::own,   WindowPreset::whole};

/// Whether it is one of Hounsfield units, which a CT alone has.
bool is_hounsfield(WindowPreset preset);
/// Those of a CT in the portal venous phase, in which livers are segmented: liver about 110 HU, veins 170.
/// @pre is_hounsfield(preset)
GreyWindow hounsfield_window(WindowPreset preset);
/// From the darkest voxel to the brightest, without one in a thousand at either end (a metal clip, a hot
/// pixel). @pre the image has voxels.
GreyWindow whole_range(const Image& image);
/// "Liver"
QString preset_text(WindowPreset preset);

}  // namespace glisson::ui
