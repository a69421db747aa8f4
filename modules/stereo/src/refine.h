// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "matching.h"

namespace glisson::stereo {

/// Moves the right end of a match to where the picture around it fits that around the left end, by least
/// squares over a patch:
///   I_l(c + o) = gain I_r(c + o - (d + a o_x + b o_y, -v)) + offset,
/// with disparity d, its slope (a, b) (a slanted surface), the rows' difference v, and both pictures' light.
/// Gauss-Newton; v is held near what
/// the other matches show, a and b near zero by what organs leave possible.
class Refiner {
 public:
  /// @param left, right rectified, grey, 8 bit. @param excluded non-zero where the left picture shows a
  ///   highlight (it moves with the camera, not with the tissue).
  Refiner(const Rectification& rectification, const cv::Mat& left, const cv::Mat& right,
          const cv::Mat& excluded, int half_width);

  /// @param row what the right row exceeds the left one by where calibration is not perfect, pixels.
  /// @return the refined match with its sigma from the residual; empty where it does not converge, lies
  ///   outside, or the patches differ (correlation below 0.7).
  std::optional<Match> refine(const Match& start, double row) const;

 private:
  struct Patch;
  struct State;
  bool sample_left(const Eigen::Vector2d& centre, Patch& patch) const;
  double search(const Patch& patch, const Match& start, double row) const;
  std::optional<double> iterate(const Patch& patch, State& state) const;

  const Rectification& rectification_;
  cv::Mat left_, right_, right_dx_, right_dy_, excluded_;
  int half_width_;
};

}  // namespace glisson::stereo
