// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/volume/morphology.h"

namespace glisson::segmentation {

/// Who reaches each voxel of `open` first, of fronts that start at the places of each: 1 for the first list,
/// 2 for the second, ...; 0 nobody. A step costs its length over the square of the depth, so that fronts run
/// through wide tissue and meet in the necks. @param depth2 squared distance to the edge of `open`, mm^2.
/// @pre at most 255 lists; places within the grid.
std::vector<std::uint8_t> first_to_reach(const Mask& open, const std::vector<float>& depth2,
                                         const std::vector<std::vector<Eigen::Vector3i>>& places);

}  // namespace glisson::segmentation
