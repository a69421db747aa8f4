// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "glisson/geometry/camera.h"

namespace glisson::stereo {

/// A blob (Bay, Ess, Tuytelaars and Van Gool 2008).
struct Keypoint {
  Eigen::Vector2d pixel;
  double scale = 1.0, score = 0.0;
  bool bright = false;  ///< sign of the Laplacian: a bright blob never matches a dark one
  std::array<float, 64> descriptor{};
};

/// The strongest blobs, spread over the image: every cell of a grid gives its best before any gives its
/// second, so that strong texture in one place does not leave the rest bare.
/// @param grey 8 bit, one channel.
/// @param usable the same size; zero: no feature here.
/// @param angle by which the descriptors are turned, radians. Not estimated per feature (the upright
/// variant):
///   how the two cameras are turned against each other is known from the calibration.
std::vector<Keypoint> detect_surf(const cv::Mat& grey, const cv::Mat& usable, int wanted, double angle);

}  // namespace glisson::stereo
