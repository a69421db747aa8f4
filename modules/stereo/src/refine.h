// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "matching.h"

namespace glisson::stereo {

/// Moves the right end of a match to where the picture around it fits that around the left end, by least
/// squares over a patch:
///   I_l(c + o) = gain I_r(c + o - (d + a o_x + b o_y + e o_x^2 + f o_x o_y + g o_y^2, -v)) + offset,
/// with disparity d, its slope (a, b) (a slanted surface), its bend (e, f, g; without it a bulge would lie
/// too far away, being averaged over the patch), the rows' difference v, and both pictures' light (gain,
/// offset). Gauss-Newton with Tukey's weights, so that highlights and edges do not count. v is held near what
/// the other matches show, the rest near what is possible of organs. The left end is moved to a whole pixel,
/// so that only one picture is interpolated.
class Refiner {
 public:
  /// @param left, right rectified, grey, 0 to 255, CV_32F: eight bits and OpenCV's warp, which rounds places
  ///   to a 32nd of a pixel, cost more than the sensor's noise. @param excluded_left, excluded_right non-zero
  ///   where the rectified pictures show a highlight (it moves with the camera, not with the tissue).
  Refiner(const Rectification& rectification, const cv::Mat& left, const cv::Mat& right,
          const cv::Mat& excluded_left, const cv::Mat& excluded_right, int half_width);

  /// @param row by how much right rows exceed left ones, where the calibration is not perfect, pixels.
  /// @return the refined match with its sigma, from the noise that the residuals show. Empty: it does not
  ///   converge, lies outside, or the patches differ (correlation below 0.7).
  std::optional<Match> refine(const Match& start, double row) const;
  /// Standard deviation of the patch's weights, pixels: matches closer than that have their errors in common.
  double reach() const;

 private:
  struct Patch;
  struct State;
  bool sample_left(const Eigen::Vector2d& centre, Patch& patch) const;
  double search(const Patch& patch, double disparity, double row) const;
  std::optional<double> iterate(const Patch& patch, State& state) const;
  double sigma(const Patch& patch, const State& state) const;

  const Rectification& rectification_;
  cv::Mat left_, left_dx_, left_dy_, right_, excluded_left_, excluded_right_;
  int half_width_;
};

}  // namespace glisson::stereo
