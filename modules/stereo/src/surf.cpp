// SPDX-License-Identifier: GPL-3.0-or-later
#include "surf.h"

#include <dlib/image_keypoint/surf.h>
#include <dlib/opencv/cv_image.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace glisson::stereo {
namespace {

// What descriptor and weights reach from the centre, in units of the scale.
constexpr double kReach = 18.0;
// Below this the response is the sensor's noise.
constexpr double kLeastResponse = 0.1;
constexpr int kCell = 24;  // pixels

std::vector<dlib::interest_point> spread(std::vector<dlib::interest_point> points, const cv::Mat& usable,
                                         int wanted) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return std::make_tuple(-a.score, a.center.y(), a.center.x(), a.scale) <
           std::make_tuple(-b.score, b.center.y(), b.center.x(), b.scale);
  });
  const int columns = usable.cols / kCell + 1;
  std::vector<int> taken(
      static_cast<std::size_t>(columns) * static_cast<std::size_t>(usable.rows / kCell + 1), 0);
  std::vector<std::pair<int, std::size_t>> order;  // rank within its cell, then strength
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int x = static_cast<int>(std::lround(points[i].center.x()));
    const int y = static_cast<int>(std::lround(points[i].center.y()));
    const int reach = static_cast<int>(kReach * points[i].scale) + 2;
    if (x < reach || y < reach || x >= usable.cols - reach || y >= usable.rows - reach) continue;
    if (usable.at<std::uint8_t>(y, x) == 0) continue;
    order.emplace_back(taken[static_cast<std::size_t>(y / kCell * columns + x / kCell)]++, i);
  }
  std::sort(order.begin(), order.end());
  std::vector<dlib::interest_point> kept;
  for (std::size_t k = 0; k < order.size() && static_cast<int>(k) < wanted; ++k)
    kept.push_back(points[order[k].second]);
  return kept;
}

}  // namespace

std::vector<Keypoint> detect_surf(const cv::Mat& grey, const cv::Mat& usable, int wanted, double angle) {
  dlib::integral_image_generic<long> integral;
  integral.load(dlib::cv_image<unsigned char>(grey));
  dlib::hessian_pyramid pyramid;
  // Steps of one pixel: laparoscopes show soft, small texture that steps of two miss.
  pyramid.build_pyramid(integral, 4, 6, 1);
  std::vector<dlib::interest_point> points;
  dlib::get_interest_points(pyramid, kLeastResponse, points);
  std::vector<Keypoint> keypoints;
  for (const dlib::interest_point& point : spread(std::move(points), usable, wanted)) {
    Keypoint keypoint;
    keypoint.pixel = {point.center.x(), point.center.y()};
    keypoint.scale = point.scale;
    keypoint.score = point.score;
    keypoint.bright = point.laplacian < 0.0;
    dlib::matrix<double, 64, 1> descriptor;
    dlib::compute_surf_descriptor(integral, point.center, point.scale, angle, descriptor);
    for (int k = 0; k < 64; ++k)
      keypoint.descriptor[static_cast<std::size_t>(k)] = static_cast<float>(descriptor(k));
    keypoints.push_back(keypoint);
  }
  return keypoints;
}

}  // namespace glisson::stereo
