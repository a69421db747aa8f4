// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/geometry/mesh.h"
#include "glisson/volume/label_volume.h"
#include "scalar_field.h"

namespace glisson::model {

/// What is to be filled with tetrahedra: a body, and sub-domains in it. A point belongs to the sub-domain
/// whose field is positive there (the first one named), else to the body, else to nothing.
struct MesherInput {
  ScalarField body;
  Label body_label = 1;
  std::vector<std::pair<Label, ScalarField>> inclusions;
  std::vector<ScalarField> refined;  ///< elements are finer where one of these is positive
};

struct MesherSizes {
  double edge = 0.02;                   ///< metres
  std::vector<double> inclusion_edges;  ///< metres, one a sub-domain
  double refined_edge = 0.02;           ///< metres, where MesherInput::refined is positive
};

/// CGAL Mesh_3 (Jamin, Alliez, Yvinec, Boissonnat 2015), sequential, then Lloyd, ODT, perturb, exude. The
/// same input and seed give the same bits. Nodes and tetrahedra in a canonical order.
/// @param smoothing_passes of Lloyd and of ODT; 0: refinement alone, nothing is optimised.
Cancellable<TetMesh> fill_with_tetrahedra(const MesherInput& input, const MesherSizes& sizes,
                                          int smoothing_passes, const RunContext& context);

}  // namespace glisson::model
