// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "ct_scene.h"
#include "glisson/geometry/mesh.h"

namespace glisson::insilico {

/// {field < 0} within the box as a closed surface with outward normals. @param spacing of the samples, mm.
/// @pre the field is positive on the box's sides. @return metres.
TriangleMesh contour(const Vec& low, const Vec& high, double spacing,
                     const std::function<double(const Vec&)>& field);

/// The tubes of a tree as one closed surface. @return metres.
TriangleMesh contour(const GrownTree& tree, double spacing);

}  // namespace glisson::insilico
