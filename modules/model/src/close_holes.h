// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/geometry/mesh.h"

namespace glisson::model {

/// Closes the holes of a surface: a cone goes from the rim of each to the rim's middle. A hole cut across a
/// tube is closed flat. Whatever a rim's shape, the edges cancel one another afterwards, so that each place
/// has a whole winding number and no row of voxels enters without leaving.
/// @return whether there was a hole; a patch that faces otherwise than what is around it counts as one.
bool close_holes(TriangleMesh& surface);

}  // namespace glisson::model
