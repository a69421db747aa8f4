// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/camera.h"

#include <Eigen/LU>

namespace glisson {
namespace {

Eigen::Vector2d distort(const Eigen::Matrix<double, 5, 1>& d, const Eigen::Vector2d& p,
                        Eigen::Matrix2d* jacobian) {
  const double x = p.x(), y = p.y(), r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (d[0] + r2 * (d[1] + r2 * d[4]));
  if (jacobian != nullptr) {
    const double slope = 2.0 * (d[0] + r2 * (2.0 * d[1] + 3.0 * r2 * d[4]));  // d radial / d r2, times 2
    (*jacobian)(0, 0) = radial + x * x * slope + 2.0 * d[2] * y + 6.0 * d[3] * x;
    (*jacobian)(0, 1) = x * y * slope + 2.0 * d[2] * x + 2.0 * d[3] * y;
    (*jacobian)(1, 0) = (*jacobian)(0, 1);
    (*jacobian)(1, 1) = radial + y * y * slope + 6.0 * d[2] * y + 2.0 * d[3] * x;
  }
  return {x * radial + 2.0 * d[2] * x * y + d[3] * (r2 + 2.0 * x * x),
          y * radial + d[2] * (r2 + 2.0 * y * y) + 2.0 * d[3] * x * y};
}

}  // namespace

Eigen::Vector2d Camera::project(const Eigen::Vector3d& p_in_camera) const {
  const Eigen::Vector2d q = distort(distortion, p_in_camera.head<2>() / p_in_camera.z(), nullptr);
  return {matrix(0, 0) * q.x() + matrix(0, 1) * q.y() + matrix(0, 2), matrix(1, 1) * q.y() + matrix(1, 2)};
}

Eigen::Vector3d Camera::ray(const Eigen::Vector2d& pixel) const {
  const double y = (pixel.y() - matrix(1, 2)) / matrix(1, 1);
  const Eigen::Vector2d target((pixel.x() - matrix(0, 2) - matrix(0, 1) * y) / matrix(0, 0), y);
  Eigen::Vector2d p = target;
  for (int pass = 0; pass < 20; ++pass) {
    Eigen::Matrix2d jacobian;
    const Eigen::Vector2d miss = distort(distortion, p, &jacobian) - target;
    if (miss.squaredNorm() < 1e-24) break;
    p -= jacobian.inverse() * miss;
  }
  return {p.x(), p.y(), 1.0};
}

}  // namespace glisson
