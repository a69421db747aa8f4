// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/geometry/mesh.h"

namespace glisson::scene {

/// Triangles of a surface, sorted by whether a camera outside of it can see their backs.
struct SidedTriangles {
  Triangles triangles;
  /// The first so many are wound outwards, and something of the surface lies before each of their backs: they
  /// need no drawing when they are turned away.
  Eigen::Index one_sided = 0;
};

/// Both sides are kept where the whole surface is open or wound in two ways, and within some rings of
/// triangles of where it is cut off: one looks into the end of a vessel.
/// @param whole the surface. @param kept those of its triangles that are drawn, with its vertices' numbers.
SidedTriangles sort_by_sides(const TriangleMesh& whole, const Triangles& kept);

}  // namespace glisson::scene
