// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block_matrix.h"
#include "glisson/fem/integrator.h"

namespace glisson::fem {

/// @throws InputError for nodes and triangles out of range, values that are not finite.
void check_loads(const CompositeModel::Impl& model, const Loads& loads);

/// Adds gravity, the pressure at x and the attached forces to `force`.
void add_external_force(const CompositeModel::Impl& model, const Loads& loads, const Points& x,
                        Points& force);

/// Adds minus the loads' derivatives to the system: attached tangents as they are, of the pressure's the
/// symmetric part, triangle by triangle; without its negative eigenvalues unless `kind` is exact.
void add_external_tangent(const CompositeModel::Impl& model, const Loads& loads, const Points& x,
                          Tangent kind, BlockSystem& system);

/// The part of the pressure's tangent that a symmetric matrix cannot hold (it vanishes on a closed surface):
/// adds its product with `direction` to `product`, both over all nodes.
void add_pressure_skew_product(const CompositeModel::Impl& model, const Loads& loads, const Points& x,
                               const Points& direction, Points& product);

}  // namespace glisson::fem
