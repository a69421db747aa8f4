// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "glisson/volume/image.h"

namespace glisson {

/// A row of voxels behind whose faces an organ goes on, though nothing is known of it there: these faces are
/// no surface.
struct CutRow {
  int axis = 0;                                     ///< the faces lie across it
  bool high = false;                                ///< towards its higher indices
  Eigen::Vector3i first = Eigen::Vector3i::Zero();  ///< voxel of the organ
  int count = 0;                                    ///< voxels along the axis that follows, (axis + 1) % 3
};

/// Whether what is known ends between a voxel of an organ and the next one, which is none of it and may lie
/// outside of the grid.
using EndsBetween = std::function<bool(const Eigen::Vector3i& here, const Eigen::Vector3i& next)>;
/// @param organ 0/1, as many as the grid has voxels.
std::vector<CutRow> cut_rows(const VolumeGrid& grid, const std::vector<std::uint8_t>& organ,
                             const EndsBetween& ends_between);

/// Where the image ends inside an organ: on its six sides, and on padding.
/// @param organ as above. @param image null: its padding is not known. A CT's voxels are padding where they
/// have its lowest value, which is none above air's, and reach its sides through such: beside a round field
/// of view, or where a tilt was resampled away. An organ inside a body never touches the air around it.
/// @pre the image has this grid
std::vector<CutRow> image_cut(const VolumeGrid& grid, const std::vector<std::uint8_t>& organ,
                              const Image* image = nullptr);

/// Of their faces.
double area_mm2(const VolumeGrid& grid, const std::vector<CutRow>& rows);

/// Less of a flat face than this is none worth telling, mm^2: a dome touches the last slice with as much.
inline constexpr double kLeastCutMm2 = 100.0;

/// "liver.cut_off 42" (cm^2); empty: less than a square centimetre, as where a dome touches the last slice.
std::optional<std::string> cut_note(const VolumeGrid& grid, const std::vector<CutRow>& liver_cut);
/// What a cut_note() among these notes tells, cm^2; 0: there is none.
long told_cut(const std::vector<std::string>& notes);

}  // namespace glisson
