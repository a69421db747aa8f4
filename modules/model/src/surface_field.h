// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/geometry/mesh.h"
#include "glisson/model/build.h"

namespace glisson::model {

/// The one large closed piece of a surface, equal vertices merged, normals outwards. Pieces below 1 % of the
/// volume are dropped.
/// @param dropped_ml if given, receives their volumes (millilitres).
/// @throws InputError open, empty, not finite, or several large pieces.
TriangleMesh largest_closed_piece(const TriangleMesh& surface, const std::string& name,
                                  std::vector<double>* dropped_ml = nullptr);

/// Sample spacing (mm) of a body's field: fine against the elements to come, and no more than some two
/// million samples.
double body_spacing_mm(const TriangleMesh& surface, const MeshOptions& options);

}  // namespace glisson::model
