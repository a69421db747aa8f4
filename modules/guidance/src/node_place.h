// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "glisson/geometry/mesh.h"

namespace glisson::guidance {

/// Of what hangs on up to four nodes by its weights; an unused node is -1. In the nodes' frame and unit.
inline Eigen::Vector3d place_of(const std::array<int, 4>& nodes, const std::array<double, 4>& weights,
                                const Points& positions) {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < 4; ++k)
    if (nodes[k] >= 0) p += weights[k] * positions.row(nodes[k]).transpose();
  return p;
}

}  // namespace glisson::guidance
