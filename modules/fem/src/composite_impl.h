// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/fem/composite_model.h"
#include "membrane.h"
#include "tetrahedron.h"
#include "vessel_beams.h"

namespace glisson::fem {

struct CompositeModel::Impl {
  TetMesh mesh;
  CompositeOptions options;
  BoundarySurface surface;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Membrane> membranes;
  VesselBeams vessels;
  Eigen::VectorXd lumped_mass;
};

}  // namespace glisson::fem
