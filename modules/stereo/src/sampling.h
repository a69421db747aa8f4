// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <opencv2/core.hpp>

namespace glisson::stereo {

/// Weights of four samples in a row for a place `t` in [0, 1) beyond the second (Catmull and Rom 1974, Keys
/// 1981): exact on cubics. Bilinear weights shift short waves by hundredths of a pixel.
inline std::array<float, 4> cubic_weights(float t) {
  const float t2 = t * t, t3 = t2 * t;
  return {0.5F * (-t + 2.0F * t2 - t3), 0.5F * (2.0F - 5.0F * t2 + 3.0F * t3),
          0.5F * (t + 4.0F * t2 - 3.0F * t3), 0.5F * (t3 - t2)};
}

/// Whether sample_cubic() has all sixteen pixels.
inline bool inside_cubic(const cv::Mat& image, double x, double y) {
  return x >= 1.0 && y >= 1.0 && x < image.cols - 2.0 && y < image.rows - 2.0;
}

/// Of a CV_32F image. @pre inside_cubic.
inline float sample_cubic(const cv::Mat& image, double x, double y) {
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const auto across = cubic_weights(static_cast<float>(x - x0));
  const auto down = cubic_weights(static_cast<float>(y - y0));
  float sum = 0.0F;
  for (int k = 0; k < 4; ++k) {
    const float* p = image.ptr<float>(y0 + k - 1) + x0 - 1;
    sum += down[static_cast<std::size_t>(k)] *
           (across[0] * p[0] + across[1] * p[1] + across[2] * p[2] + across[3] * p[3]);
  }
  return sum;
}

}  // namespace glisson::stereo
