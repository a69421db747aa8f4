// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/stereo/reconstruct.h"

namespace glisson::stereo {

/// A place that can be found again.
struct Keypoint {
  Eigen::Vector2d pixel;
  double scale = 1.0, score = 0.0;
  bool bright = false;  ///< SURF: sign of the Laplacian; a bright blob never matches a dark one
  std::array<float, 128> descriptor{};  ///< compared by Euclidean distance; the rest of shorter ones is 0
};

/// One kind of features. Upright: descriptors are not turned by each feature's own direction, but by how the
/// two cameras are turned against each other, which the calibration knows.
class FeatureDetector {
 public:
  virtual ~FeatureDetector() = default;
  /// The strongest features, spread over the image (see spread()): the threshold adapts to the wanted count.
  /// @param grey 8 bit, one channel. @param usable the same size; zero: no feature here.
  /// @param angle by which the descriptors are turned, radians.
  virtual std::vector<Keypoint> detect(const cv::Mat& grey, const cv::Mat& usable, int wanted,
                                       double angle) const = 0;
  virtual int descriptor_length() const = 0;
};
std::unique_ptr<FeatureDetector> feature_detector(Features kind);
/// dlib's SURF (Bay 2008), in a file of its own.
std::unique_ptr<FeatureDetector> surf_detector();

/// Which keypoints to keep, before their descriptors are computed: every cell of a grid gives its best before
/// any gives its second, so that strong texture in one place does not take all.
/// @param reach of a descriptor from its centre, in units of the scale: what does not fit into the picture is
///   left out.
/// @return indices.
std::vector<std::size_t> spread(const std::vector<Keypoint>& keypoints, const cv::Mat& usable, int wanted,
                                double reach);

}  // namespace glisson::stereo
