// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "glisson/geometry/mesh.h"
#include "glisson/volume/grid.h"

namespace glisson::model {

/// Where the image ends inside an organ: the outer faces of its voxels on the image's six sides, rows of them
/// as one rectangle. CT frame, metres; vertices are not shared. Empty: nowhere.
/// @param organ 0/1, as many as the grid has voxels.
TriangleMesh cut_faces(const VolumeGrid& grid, const std::vector<std::uint8_t>& organ);

}  // namespace glisson::model
