// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glisson/volume/grid.h"

namespace glisson {

/// How much of an organ's surface is none, because the image ends inside the organ, mm^2: the faces of its
/// voxels on the image's six sides. @param organ 0/1, as many as the grid has voxels.
double cut_area_mm2(const VolumeGrid& grid, const std::vector<std::uint8_t>& organ);

/// Less of a flat face than this is none worth telling, mm^2: a dome touches the last slice with as much.
inline constexpr double kLeastCutMm2 = 100.0;

/// "liver.cut_off 42" (cm^2); empty: less than a square centimetre, as where a dome touches the last slice.
std::optional<std::string> cut_note(const VolumeGrid& grid, const std::vector<std::uint8_t>& liver);
/// What a cut_note() among these notes tells, cm^2; 0: there is none.
long told_cut(const std::vector<std::string>& notes);

}  // namespace glisson
