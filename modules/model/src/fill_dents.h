// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/core/run_context.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/mesh.h"

namespace glisson::model {

/// Fills dents of the boundary: nodes below the surface with no cells above them. The refinement keeps a cell
/// if its circumcentre lies in the body; that of a flat cell between a lesion and the surface does not, so it
/// is missing. Cells are put on such a node, which then is an inner one; the boundary stays a manifold.
/// @param surface fine, normals outwards, of the body; `normals` of its triangles.
/// @param label of the cells that are put in.
/// @return how many nodes were covered. No cell with a dihedral angle below `least_dihedral_deg`, none that
///   reaches into another or stands out of the body. Cancelled: those until then.
int fill_dents(TetMesh& mesh, const ClosestPointTree& surface, const Points& normals, int label,
               double least_dihedral_deg, const RunContext& context);

}  // namespace glisson::model
