// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/core.hpp>
#include <optional>

namespace glisson::guidance {

/// A disparity and what the noise of the two pictures leaves of it, pixels.
struct FittedDisparity {
  double disparity = 0.0, sigma = 0.0;
};

/// Moves a disparity to where both pictures agree best about a pixel of the left one, by least squares over a
/// patch: I_l(c + o) = gain I_r(c + o - (d + a o_x + b o_y)) + offset (Gauss-Newton; slope a, b and light
/// gain and offset are free). What smoothness alone has put there is not confirmed: where the picture has too
/// little texture for its noise, sigma tells it.
/// @param left, right rectified, CV_8U, of one size. @param x, y pixel of the left picture.
/// @param start pixels: where x_left - x_right is looked for.
/// @return empty: it does not lie within a pixel of `start`, the patch leaves the picture, its disparity is
///   known worse than to half a pixel, or less than half of what the patches show is in both.
std::optional<FittedDisparity> fit_disparity(const cv::Mat& left, const cv::Mat& right, int x, int y,
                                             double start);

}  // namespace glisson::guidance
