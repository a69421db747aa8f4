// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/model/build.h"
#include "mesher.h"

namespace glisson::model {

/// No cell of a mesh is to have a smaller dihedral angle, degrees.
inline constexpr double kLeastDihedral = 10.0;

/// Third root of the volume that one node stands for, metres; `volume` of the body, m3.
double typical_edge(double volume, const MeshOptions& options);

/// Meshes so that the number of nodes comes within 10 % of what is wanted: the edge length is searched on
/// bare refinements, then one mesh is optimised. A mesh with slivers (below 10 degrees) or a boundary that is
/// no closed manifold is made anew at a slightly other size.
/// @param notes receives codes with values for what could not be met.
Cancellable<TetMesh> mesh_to_size(const MesherInput& input, const MeshOptions& options,
                                  std::vector<std::string>& notes, const RunContext& context);

}  // namespace glisson::model
