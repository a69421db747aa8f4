// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/mesh.h"
#include "glisson/volume/label_volume.h"

namespace glisson::model {

/// What a finished mesh is brought nearer to.
struct FitTargets {
  const TriangleMesh* surface = nullptr;  ///< fine, closed, normals outwards
  double volume = 0.0;                    ///< m3, within the surface
  struct Inclusion {
    Label label = 0;
    double volume = 0.0;  ///< m3
  };
  std::vector<Inclusion> inclusions;  ///< sub-domains of the mesh
};

/// Moves nodes of a finished mesh, none so far that a cell gets a dihedral angle below `least_dihedral_deg`
/// (or a worse one than it had):
/// - boundary nodes go onto the surface. The repair of the boundary has left former inner nodes on it, and
///   smoothing has moved others off the surface. Where a cell would get flat, the nodes around make room;
/// - dents that remain are filled with cells of the body's label (fill_dents.h), the only change of topology;
/// - boundary nodes go out of the surface by at most 0.15 mm, as far as the volume asks for, since flat
///   triangles cut a round body short;
/// - the nodes around a sub-domain go out (or in) until it has its volume.
/// @pre positively oriented tetrahedra.
/// @return whether it came to its end; false: it was cancelled, and the mesh is fitted in part.
bool fit_to_surface(TetMesh& mesh, const FitTargets& targets, double least_dihedral_deg,
                    const RunContext& context);

}  // namespace glisson::model
