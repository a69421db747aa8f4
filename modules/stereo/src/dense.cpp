// SPDX-License-Identifier: GPL-3.0-or-later
#include "dense.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "glisson/core/statistics.h"

namespace glisson::stereo {
namespace {

// Coarser than this nothing is gained: each sample is refined at full resolution.
constexpr int kWidest = 960;
constexpr int kMostDisparities = 256;
constexpr int kMostSamples = 20000;

cv::Mat compute(const cv::Mat& first, const cv::Mat& second, int least, int count) {
  constexpr int kBlock = 5;
  const auto matcher = cv::StereoSGBM::create(least, count, kBlock, 8 * kBlock * kBlock, 32 * kBlock * kBlock,
                                              -1, 31, 5, 100, 2, cv::StereoSGBM::MODE_SGBM_3WAY);
  // The matcher gives nothing near the border, where part of the disparities leaves the picture: widen it.
  const int room = std::max(0, least + count);
  cv::Mat a, b, raw, result;
  cv::copyMakeBorder(first, a, 0, 0, room, 0, cv::BORDER_REPLICATE);
  cv::copyMakeBorder(second, b, 0, 0, room, 0, cv::BORDER_REPLICATE);
  matcher->compute(a, b, raw);
  raw.colRange(room, raw.cols).convertTo(result, CV_32F, 1.0 / 16.0);
  result.setTo(std::numeric_limits<float>::quiet_NaN(), result < static_cast<float>(least));
  return result;
}

/// Left to right, where right to left agrees.
cv::Mat checked(const cv::Mat& left, const cv::Mat& right, int least, int count) {
  cv::Mat forward = compute(left, right, least, count);
  cv::Mat flipped_left, flipped_right, backward;
  cv::flip(left, flipped_left, 1);
  cv::flip(right, flipped_right, 1);
  cv::flip(compute(flipped_right, flipped_left, least, count), backward, 1);
  for (int y = 0; y < forward.rows; ++y)
    for (int x = 0; x < forward.cols; ++x) {
      float& d = forward.at<float>(y, x);
      if (!(d == d)) continue;
      const int column = static_cast<int>(std::lround(static_cast<float>(x) - d));
      const bool agrees =
          column >= 0 && column < forward.cols && std::abs(backward.at<float>(y, column) - d) <= 1.0F;
      if (!agrees) d = std::numeric_limits<float>::quiet_NaN();
    }
  return forward;
}

double median_of_valid(const cv::Mat& values) {
  std::vector<float> valid;
  for (int y = 0; y < values.rows; y += 2)
    for (int x = 0; x < values.cols; x += 2)
      if (values.at<float>(y, x) == values.at<float>(y, x)) valid.push_back(values.at<float>(y, x));
  if (valid.empty()) return std::numeric_limits<double>::quiet_NaN();
  return upper_median(std::move(valid));
}

}  // namespace

std::vector<Match> dense_matches(const Rectification& rectification, const cv::Mat& left,
                                 const cv::Mat& right, const cv::Mat& usable, const MatchLimits& limits,
                                 double points_per_cm2) {
  const double scale = std::min(1.0, static_cast<double>(kWidest) / left.cols);
  cv::Mat small_left, small_right;
  cv::resize(left, small_left, cv::Size(), scale, scale, cv::INTER_AREA);
  cv::resize(right, small_right, cv::Size(), scale, scale, cv::INTER_AREA);
  const int least =
      static_cast<int>(std::floor(scale * rectification.column_difference(limits.least_disparity)));
  const int most =
      static_cast<int>(std::ceil(scale * rectification.column_difference(limits.largest_disparity)));
  const int count = std::min(kMostDisparities, (std::max(1, most - least) + 15) / 16 * 16);
  const cv::Mat disparities = checked(small_left, small_right, least, count);
  const double middle = median_of_valid(disparities) / scale - rectification.column_difference(0.0);
  if (!(middle > 0.0)) return {};

  const double pixels_per_cm = rectification.focal() / rectification.depth_at(middle) * 0.01;
  double spacing = std::max(2.0, pixels_per_cm / std::sqrt(points_per_cm2));
  spacing = std::max(spacing, std::sqrt(static_cast<double>(left.total()) / kMostSamples));
  std::vector<Match> matches;
  for (double y = 0.5 * spacing; y < left.rows; y += spacing)
    for (double x = 0.5 * spacing; x < left.cols; x += spacing) {
      const auto row = static_cast<int>(y), column = static_cast<int>(x);
      if (usable.at<std::uint8_t>(row, column) == 0) continue;
      const int small_row = std::min(disparities.rows - 1, static_cast<int>(row * scale));
      const int small_column = std::min(disparities.cols - 1, static_cast<int>(column * scale));
      const double d = disparities.at<float>(small_row, small_column) / scale;
      if (!(d == d)) continue;
      matches.push_back({{column, row}, {column - d, row}});
    }
  return matches;
}

}  // namespace glisson::stereo
