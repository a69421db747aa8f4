// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "glisson/core/error.h"
#include "glisson/stereo/source.h"
#include "picture_cv.h"

namespace glisson::stereo {
namespace {

constexpr int kRays = 180;
constexpr int kDark = 18;             // grey levels: what the sensor shows without light
constexpr double kOnCircle = 0.012;   // of the radius
constexpr double kLeastShare = 0.25;  // of the rays that end on the circle
constexpr double kLeastOf = 0.8;      // of those that end inside the picture at all

/// Where each ray from the middle leaves the light for good, inside the picture.
std::vector<Eigen::Vector2d> edges(const cv::Mat& image) {
  const Eigen::Vector2d middle(0.5 * (image.cols - 1), 0.5 * (image.rows - 1));
  std::vector<Eigen::Vector2d> found;
  for (int k = 0; k < kRays; ++k) {
    const double angle = 2.0 * M_PI * k / kRays;
    const Eigen::Vector2d step(std::cos(angle), std::sin(angle));
    Eigen::Vector2d last = middle;
    double dark_beyond = 0.0, length = 0.0;
    for (Eigen::Vector2d p = middle;; p += step, ++length) {
      const int x = static_cast<int>(std::lround(p.x())), y = static_cast<int>(std::lround(p.y()));
      if (x < 0 || y < 0 || x >= image.cols || y >= image.rows) break;
      if (image.at<std::uint8_t>(y, x) > kDark)
        last = p, dark_beyond = 0.0;
      else
        ++dark_beyond;
    }
    if (dark_beyond >= 4.0 && dark_beyond < 0.9 * length) found.push_back(last);
  }
  return found;
}

std::optional<ScopeCircle> through(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                   const Eigen::Vector2d& c) {
  Eigen::Matrix2d m;
  m << (b - a).transpose(), (c - a).transpose();
  if (std::abs(m.determinant()) < 1.0) return std::nullopt;
  const Eigen::Vector2d offset =
      m.inverse() * Eigen::Vector2d(0.5 * (b - a).squaredNorm(), 0.5 * (c - a).squaredNorm());
  return ScopeCircle{a + offset, offset.norm()};
}

std::vector<Eigen::Vector2d> on_circle(const ScopeCircle& circle,
                                       const std::vector<Eigen::Vector2d>& points) {
  std::vector<Eigen::Vector2d> result;
  for (const Eigen::Vector2d& p : points)
    if (std::abs((p - circle.centre).norm() - circle.radius) < std::max(1.5, kOnCircle * circle.radius))
      result.push_back(p);
  return result;
}

/// Least squares, algebraic: x^2 + y^2 + a x + b y + c = 0.
ScopeCircle fitted(const std::vector<Eigen::Vector2d>& points) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd right(rows.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Eigen::Vector2d& p = points[static_cast<std::size_t>(i)];
    rows.row(i) << p.x(), p.y(), 1.0;
    right[i] = -p.squaredNorm();
  }
  const Eigen::Vector3d s = rows.colPivHouseholderQr().solve(right);
  const Eigen::Vector2d centre(-0.5 * s[0], -0.5 * s[1]);
  return {centre, std::sqrt(std::max(0.0, centre.squaredNorm() - s[2]))};
}

}  // namespace

std::optional<ScopeCircle> find_scope_circle(const Picture& picture) {
  cv::Mat image;
  cv::medianBlur(grey(picture), image, 5);
  const std::vector<Eigen::Vector2d> points = edges(image);
  if (static_cast<double>(points.size()) < kLeastShare * kRays) return std::nullopt;
  // Every third of the points a way round: enough triples to meet one without outliers, the same on every
  // run.
  std::optional<ScopeCircle> best;
  std::size_t most = 0;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i)
    for (const std::size_t step : {n / 3, n / 5, n / 9}) {
      const auto circle = through(points[i], points[(i + step) % n], points[(i + 2 * step) % n]);
      if (!circle || circle->radius < 0.25 * image.rows || circle->radius > 1.2 * image.cols) continue;
      const std::size_t count = on_circle(*circle, points).size();
      if (count > most) most = count, best = circle;
    }
  if (!best) return std::nullopt;
  for (int pass = 0; pass < 3; ++pass) best = fitted(on_circle(*best, points));
  const auto count = static_cast<double>(on_circle(*best, points).size());
  if (count < kLeastShare * kRays || count < kLeastOf * static_cast<double>(n)) return std::nullopt;
  return best;
}

Picture circle_mask(const ScopeCircle& circle, int width, int height, double margin_px) {
  require(width > 0 && height > 0 && circle.radius > 0.0, "a mask has a size, and a circle a radius");
  cv::Mat mask = cv::Mat::zeros(height, width, CV_8U);
  const double radius = std::max(0.0, circle.radius - margin_px);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if ((Eigen::Vector2d(x, y) - circle.centre).squaredNorm() <= radius * radius)
        mask.at<std::uint8_t>(y, x) = 255;
  return to_picture(mask);
}

}  // namespace glisson::stereo
