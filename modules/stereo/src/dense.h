// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching.h"

namespace glisson::stereo {

/// Semi-global matching (Hirschmüller 2008) of a rectified pair, checked from left to right and back, sampled
/// on a grid whose cells hold one point each at the wanted density. Precise to about half a pixel; refine()
/// does the rest.
/// @param left, right rectified, grey, 8 bit. @param usable of the rectified left picture.
std::vector<Match> dense_matches(const Rectification& rectification, const cv::Mat& left,
                                 const cv::Mat& right, const cv::Mat& usable, const MatchLimits& limits,
                                 double points_per_cm2);

}  // namespace glisson::stereo
