// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "feature_detector.h"
#include "rectification.h"

namespace glisson::stereo {

/// One scene point in both pictures. Coordinates are rectified; refine() makes the right one precise.
struct Match {
  Eigen::Vector2d left, right;
  double sigma = 1.0;  ///< standard deviation of the disparity, pixels
};

struct MatchLimits {
  double ratio = 0.8, rows = 3.0;                         ///< Lowe's; largest difference of rows, pixels
  double least_disparity = 0.0, largest_disparity = 1e9;  ///< what depths allow, pixels
};

/// Keypoints with their rectified positions, those that have one.
struct Rectified {
  std::vector<Keypoint> keypoints;
  std::vector<Eigen::Vector2d> positions;
  int length = 64;  ///< of the descriptors
};
Rectified rectify(const Rectification& rectification, Side side, std::vector<Keypoint> keypoints, int length);

/// Descriptors compared only along the epipolar band; best of both directions (cross check) and clearly
/// better than the second in the band (ratio). Disparities may have any sign: the caller judges them.
std::vector<Match> match(const Rectified& left, const Rectified& right, const MatchLimits& limits);

/// How well matches and calibration go together.
struct Fit {
  int plausible = 0;  ///< matches at a depth within the limits
  double rows = 0.0;  ///< median difference of their rows, pixels
};
Fit fit_of(const Rectification& rectification, const std::vector<Match>& matches, const MatchLimits& limits);

}  // namespace glisson::stereo
