// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/epipolar.h"

#include "glisson/core/error.h"

namespace glisson::stereo {

EpipolarLine epipolar_line(const StereoRig& rig, Side side, const Eigen::Vector2d& pixel, double near,
                           double far) {
  require(near > 0.0 && far > near, "depths are positive, far beyond near");
  constexpr int kSteps = 96;
  const Camera& from = side == Side::left ? rig.left : rig.right;
  const Camera& to = side == Side::left ? rig.right : rig.left;
  const Eigen::Matrix3d& r = rig.right_from_left.rotation;
  const Eigen::Vector3d& t = rig.right_from_left.translation;
  const auto ray = from.mapped_ray(pixel);
  EpipolarLine line;
  if (!ray) return line;
  for (int k = 0; k <= kSteps; ++k) {
    const double share = static_cast<double>(k) / kSteps;
    const double depth = 1.0 / ((1.0 - share) / near + share / far);
    const Eigen::Vector3d p = depth * *ray;
    const Eigen::Vector3d in_other =
        side == Side::left ? Eigen::Vector3d(r * p + t) : Eigen::Vector3d(r.transpose() * (p - t));
    if (!to.shows(in_other)) continue;
    line.pixels.push_back(to.project(in_other));
    line.depths.push_back(depth);
  }
  return line;
}

}  // namespace glisson::stereo
