// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangulate.h"

#include <Eigen/Dense>

namespace glisson::guidance {

Triangulated triangulate(const StereoRig& rig, const Eigen::Vector2d& left, const Eigen::Vector2d& right) {
  Triangulated result;
  const auto left_from_right = rig.right_from_left.inverse();
  const auto left_ray = rig.left.mapped_ray(left), right_ray = rig.right.mapped_ray(right);
  if (!left_ray || !right_ray) return result;
  const Eigen::Vector3d a = left_ray->normalized();
  const Eigen::Vector3d b = (left_from_right.rotation * *right_ray).normalized();
  const Eigen::Vector3d eye = left_from_right.translation;  // of the right camera
  const double cosine = a.dot(b), sine2 = 1.0 - cosine * cosine;
  if (!(sine2 > 1e-10)) return result;
  // Feet of the common perpendicular: a * s and eye + b * t.
  const double s = (eye.dot(a) - cosine * eye.dot(b)) / sine2;
  const double t = (cosine * eye.dot(a) - eye.dot(b)) / sine2;
  const Eigen::Vector3d on_left = s * a, on_right = eye + t * b;
  if (!(s > 0.0 && t > 0.0)) return result;
  result.p = 0.5 * (on_left + on_right);
  result.epipolar_px = (on_left - on_right).norm() / s * rig.left.matrix(0, 0);
  const double along = std::min(1.0, 0.5 * rig.baseline() * rig.baseline() / (s * s));
  result.information = Eigen::Matrix3d::Identity() - (1.0 - along) * a * a.transpose();
  result.good = result.p.z() > 0.0;
  return result;
}

}  // namespace glisson::guidance
