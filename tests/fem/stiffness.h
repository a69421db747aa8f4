// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>

#include "glisson/fem/composite_model.h"
#include "tetrahedron.h"

namespace glisson::fem {

/// The model's tangent stiffness at node positions x: 3N x 3N, N/m, symmetric, both triangles, three rows a
/// node. `exact` is minus the internal force's derivative.
/// @pre x holds one row a node.
Eigen::SparseMatrix<double> stiffness_matrix(const CompositeModel& model, const Points& x, Tangent kind);

/// Gravity, pressure at x and attached forces on the nodes, N. @throws InputError for loads that do not fit.
Points external_force(const CompositeModel& model, const Loads& loads, const Points& x);

/// What the loads add to the system matrix: attached tangents, and the symmetric part of minus the pressure
/// force's derivative (without its negative eigenvalues, triangle by triangle, unless `kind` is exact).
Eigen::SparseMatrix<double> load_stiffness_matrix(const CompositeModel& model, const Loads& loads,
                                                  const Points& x, Tangent kind);

}  // namespace glisson::fem
