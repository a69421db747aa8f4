// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace glisson::model {

/// Cosine of a tetrahedron's smallest dihedral angle; 2 when it is flat or inside out.
inline double worst_cosine(const std::array<Eigen::Vector3d, 4>& p) {
  if ((p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]) <= 0.0) return 2.0;
  static constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  std::array<Eigen::Vector3d, 4> n;
  for (std::size_t f = 0; f < 4; ++f) {
    const auto [a, b, c] = kFaces[f];
    n[f] = (p[static_cast<std::size_t>(b)] - p[static_cast<std::size_t>(a)])
               .cross(p[static_cast<std::size_t>(c)] - p[static_cast<std::size_t>(a)])
               .normalized();
  }
  double worst = -1.0;
  for (std::size_t f = 0; f < 4; ++f)
    for (std::size_t g = f + 1; g < 4; ++g) worst = std::max(worst, -n[f].dot(n[g]));
  return worst;
}

}  // namespace glisson::model
