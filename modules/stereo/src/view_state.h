// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "glisson/patient/picture.h"
#include "glisson/stereo/faults.h"

namespace glisson::stereo {

/// A picture of 96 pixels' width, grey, 32-bit float: enough to see motion by, and noise nearly gone.
cv::Mat thumbnail(const Picture& picture);
cv::Mat thumbnail(const cv::Mat& grey);
/// Mean of the absolute difference, grey levels.
double difference(const cv::Mat& a, const cv::Mat& b);
/// What two views of a moment tell without any other: black, lost, the same.
std::vector<Fault> faults_of_views(const cv::Mat& left, const cv::Mat& right);

}  // namespace glisson::stereo
