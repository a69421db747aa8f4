// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/mesh.h"

namespace glisson::model {

/// Puts cells on boundary nodes that lie in dents: below the surface, where the refinement left out the cells
/// above them (it takes a cell whose circumcentre is in the body, and that of a flat one under the surface,
/// over a lesion, is not). The node is an inner one then, and the boundary stays a manifold.
/// @param surface fine, normals outwards, of the body; `normals` of its triangles.
/// @param label of the cells that are put in.
/// @return how many nodes were covered. No cell with a dihedral angle below `least_dihedral_deg`, none that
///   reaches into another or stands out of the body.
int fill_dents(TetMesh& mesh, const ClosestPointTree& surface, const Points& normals, int label,
               double least_dihedral_deg);

}  // namespace glisson::model
