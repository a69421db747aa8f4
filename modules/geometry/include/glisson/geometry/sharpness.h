// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/geometry/mesh.h"

namespace glisson {

/// The same surface with more vertices: triangles are cut into four until the mean edge is short enough, or
/// there are 400 000 of them. @param edge metres
TriangleMesh refined(TriangleMesh mesh, double edge);

/// Metres: how far the patch around a vertex reaches.
inline constexpr double kSharpnessRadius = 0.012;

/// How far the normals spread around each vertex: 1 - |mean normal| over the connected patch within 12 mm.
/// 0 on a plane, 1 - cos(a / 2) on a crease between normals an angle a apart, negative where the surface is
/// hollow. An integral, so that the tessellation does not matter.
class Sharpness {
 public:
  explicit Sharpness(const TriangleMesh& mesh);

  const std::vector<double>& value() const { return value_; }
  /// The mean normal of a vertex' patch.
  Eigen::Vector3d normal(int v) const { return mean_normal_.row(v).transpose(); }

 private:
  Points mean_normal_;
  std::vector<double> value_;
};

}  // namespace glisson
