// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace glisson::fem {

/// det(m) m^-T, whether m can be inverted or not.
inline Eigen::Matrix3d cofactor(const Eigen::Matrix3d& m) {
  Eigen::Matrix3d c;
  c.col(0) = m.col(1).cross(m.col(2));
  c.col(1) = m.col(2).cross(m.col(0));
  c.col(2) = m.col(0).cross(m.col(1));
  return c;
}

}  // namespace glisson::fem
