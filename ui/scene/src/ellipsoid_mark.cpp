// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/ellipsoid_mark.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace glisson::scene {

Points cut(const EllipsoidMark& mark, const SliceGeometry& slice) {
  constexpr int kCorners = 48;
  const Eigen::Vector3d normal = slice.right.cross(slice.down).normalized();
  const double off = -slice.distance_of(Point<CtFrame>(mark.p));
  // With x = p + L u the ellipsoid is |u|^2 <= distance2, and the slice the plane (L^T n) u = off.
  const Eigen::Matrix3d root = mark.covariance.llt().matrixL();
  const Eigen::Vector3d across = root.transpose() * normal;
  const double way = off / across.norm();
  const double radius2 = mark.distance2 - way * way;
  if (!(radius2 > 0.0)) return Points(0, 3);
  const Eigen::Vector3d axis = across.normalized(), one = axis.unitOrthogonal(), other = axis.cross(one);
  Points line(kCorners, 3);
  for (int k = 0; k < kCorners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kCorners;
    const Eigen::Vector3d u =
        way * axis + std::sqrt(radius2) * (std::cos(angle) * one + std::sin(angle) * other);
    line.row(k) = (mark.p + root * u).transpose();
  }
  return line;
}

}  // namespace glisson::scene
