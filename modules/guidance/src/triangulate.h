// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "glisson/geometry/camera.h"

namespace glisson::guidance {

/// A point from its two pixels.
struct Triangulated {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();  ///< left camera's frame, metres
  double epipolar_px = 0.0;  ///< how far the two rays pass by each other, in pixels of the left camera
  bool good = false;         ///< in front of both cameras, whose lenses map it; rays not parallel
  /// Inverse covariance over that of a pixel's sideways error: 1 across the ray, less along it.
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
};

/// Where the rays through two pixels (distortion removed) pass each other most closely. The depth's variance
/// is larger than the sideways one by (z / baseline)^2; `information` says so.
Triangulated triangulate(const StereoRig& rig, const Eigen::Vector2d& left, const Eigen::Vector2d& right);

}  // namespace glisson::guidance
