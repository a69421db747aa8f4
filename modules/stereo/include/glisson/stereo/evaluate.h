// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/geometry/distance.h"
#include "glisson/patient/labelled_cloud.h"

namespace glisson::stereo {

/// How far a cloud is from a known truth. Only final comparisons call this.
struct CloudErrors {
  DistanceSummary distance;  ///< unsigned, metres
  double bias = 0.0;         ///< signed median, metres; positive: the cloud lies too far from the camera
  /// Median of (error / sigma)^2 over 0.455, the value of a calibrated sigma; 0 when the cloud has no sigma.
  double normalised = 0.0;
  int without_truth = 0;       ///< points that the truth says nothing about
  DistanceSummary unbiased;    ///< of |error - bias|: what is left without an offset common to all points
  std::vector<double> errors;  ///< signed, of each point, metres; NaN: the truth says nothing about it
};

/// To the closest point of a surface in the camera's frame. The sign follows the ray.
CloudErrors cloud_errors(const LabelledCloud& cloud, const TriangleMesh& surface_in_camera);

/// Along each point's ray to a depth map of the left camera (distorted pixels).
/// @param depth along z, metres, row-major, camera.width * camera.height; 0: unknown.
/// @pre depth has that many entries.
CloudErrors cloud_errors(const LabelledCloud& cloud, const Camera& left, const std::vector<float>& depth);

}  // namespace glisson::stereo
