// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "glisson/patient/picture.h"

/// @file
/// Pictures as OpenCV has them, for what experiments do to them.

namespace glisson::experiments {

/// The picture's own bytes, to be read only. @pre not empty.
inline cv::Mat view_of(const Picture& picture) {
  return {picture.height, picture.width, picture.channels == 1 ? CV_8UC1 : CV_8UC3,
          const_cast<std::uint8_t*>(picture.bytes->data())};
}

/// A copy. @pre `mat` is continuous, 8 bits.
inline Picture picture_of(const cv::Mat& mat) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(mat.data, mat.data + mat.total() * mat.elemSize());
  return {mat.cols, mat.rows, mat.channels(), std::move(bytes)};
}

/// @param sigma grey levels.
inline void add_noise(cv::Mat& picture, double sigma, std::uint64_t seed) {
  cv::RNG random(seed);
  cv::Mat noise(picture.size(), CV_16SC(picture.channels())), sum;
  random.fill(noise, cv::RNG::NORMAL, 0.0, sigma);
  picture.convertTo(sum, noise.type());
  sum += noise;
  sum.convertTo(picture, picture.type());
}

}  // namespace glisson::experiments
