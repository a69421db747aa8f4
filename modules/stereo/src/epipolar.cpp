// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/epipolar.h"

#include "glisson/core/error.h"

namespace glisson::stereo {

EpipolarLine epipolar_line(const StereoRig& rig, Side side, const Eigen::Vector2d& pixel, double near,
                           double far) {
  require(near > 0.0 && far > near, "depths are positive, far beyond near");
  constexpr int kSteps = 96;
  constexpr double kFolded = 0.5;  // pixels: beyond where the distortion turns back, a ray returns elsewhere
  const Camera& from = side == Side::left ? rig.left : rig.right;
  const Camera& to = side == Side::left ? rig.right : rig.left;
  const Eigen::Matrix3d& r = rig.right_from_left.rotation;
  const Eigen::Vector3d& t = rig.right_from_left.translation;
  const Eigen::Vector3d ray = from.ray(pixel);
  EpipolarLine line;
  for (int k = 0; k <= kSteps; ++k) {
    const double share = static_cast<double>(k) / kSteps;
    const double depth = 1.0 / ((1.0 - share) / near + share / far);
    const Eigen::Vector3d p = depth * ray;
    const Eigen::Vector3d in_other =
        side == Side::left ? Eigen::Vector3d(r * p + t) : Eigen::Vector3d(r.transpose() * (p - t));
    if (in_other.z() <= 0.0) continue;
    const Eigen::Vector2d place = to.project(in_other);
    if (!to.sees(place)) continue;
    const Eigen::Vector3d back = to.ray(place);
    const double miss = (back.head<2>() - in_other.head<2>() / in_other.z()).norm() * to.matrix(0, 0);
    if (!(miss < kFolded)) continue;
    line.pixels.push_back(place);
    line.depths.push_back(depth);
  }
  return line;
}

}  // namespace glisson::stereo
