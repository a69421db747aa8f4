// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "glisson/geometry/camera.h"

namespace glisson::stereo {

inline cv::Mat to_cv(const Eigen::MatrixXd& m) {
  cv::Mat result(static_cast<int>(m.rows()), static_cast<int>(m.cols()), CV_64F);
  for (int r = 0; r < result.rows; ++r)
    for (int c = 0; c < result.cols; ++c) result.at<double>(r, c) = m(r, c);
  return result;
}

/// @pre matrix 3x3 and at most five distortion terms, CV_64F.
inline Camera to_camera(const cv::Mat& matrix, const cv::Mat& distortion, int width, int height) {
  Camera camera;
  camera.width = width;
  camera.height = height;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) camera.matrix(r, c) = matrix.at<double>(r, c);
  for (int i = 0; i < std::min(5, static_cast<int>(distortion.total())); ++i)
    camera.distortion[i] = distortion.at<double>(i);
  return camera;
}

}  // namespace glisson::stereo
