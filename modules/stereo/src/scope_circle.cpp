// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/stereo/source.h"
#include "picture_cv.h"

namespace glisson::stereo {
namespace {

constexpr int kRays = 180;
constexpr double kOnCircle = 0.012;     // of the radius
constexpr double kLeastShare = 0.25;    // of the rays that end on the circle
constexpr double kLeastOf = 0.7;        // of those that end inside the picture at all
constexpr double kMostLight = 0.03;     // of what is outside
constexpr double kLeastOutside = 0.01;  // of the picture
constexpr double kWidestGap = M_PI;  // between neighbouring rays on the circle: less is no more than an arc
constexpr double kLeastAspect = 0.45, kLargestAspect = 2.2;  // views squeezed to half their width or height
constexpr double kRounder = 1.15;  // an ellipse must explain so many times the rays of a circle

std::vector<std::uint8_t> values_in(const cv::Mat& image, const cv::Rect& rect) {
  std::vector<std::uint8_t> values;
  for (int y = rect.y; y < rect.y + rect.height; ++y)
    values.insert(values.end(), image.ptr(y) + rect.x, image.ptr(y) + rect.x + rect.width);
  return values;
}

/// The highest grey level that still counts as dark, from the noise of the picture's corners: the second
/// darkest of the four (one may lie in a shadow, two may be lit). Empty: the corners are too light.
std::optional<double> dark_level(const cv::Mat& image) {
  constexpr double kInset = 0.02, kSide = 0.04;           // of width and height; the margin is often blank
  constexpr double kLeastAbove = 2.5, kDeviations = 3.0;  // grey levels; of the 95th percentile
  constexpr double kLightest = 40.0, kDarker = 0.6;       // than the middle
  const int w = image.cols, h = image.rows;
  const cv::Size size(std::max(3, static_cast<int>(kSide * w)), std::max(3, static_cast<int>(kSide * h)));
  const int x = static_cast<int>(kInset * w), y = static_cast<int>(kInset * h);
  std::vector<double> levels;
  for (const cv::Point corner :
       {cv::Point(x, y), cv::Point(w - x - size.width, y), cv::Point(x, h - y - size.height),
        cv::Point(w - x - size.width, h - y - size.height)}) {
    std::vector<std::uint8_t> values = values_in(image, cv::Rect(corner, size));
    const double middle = lower_percentile(values, 0.5);
    levels.push_back(
        middle + std::max(kLeastAbove, kDeviations * (lower_percentile(std::move(values), 0.95) - middle)));
  }
  std::sort(levels.begin(), levels.end());
  const std::vector<std::uint8_t> lit = values_in(image, {w / 4, h / 4, w / 2, h / 2});
  if (levels[1] > std::min(kLightest, kDarker * lower_percentile(lit, 0.5))) return std::nullopt;
  return levels[1];
}

/// Lines of a recorder, and what a filter made of them, are no part of the scope's picture.
int margin_of(const cv::Mat& image) { return std::max(3, image.rows / 100); }

/// Mean along a ray, between two distances from `p`, pixels.
double mean(const cv::Mat& image, const Eigen::Vector2d& p, const Eigen::Vector2d& step, double from,
            double to) {
  constexpr int kSamples = 6;
  double sum = 0.0;
  for (int k = 0; k < kSamples; ++k) {
    const Eigen::Vector2d at = p + (from + (to - from) * k / (kSamples - 1)) * step;
    sum += image.at<std::uint8_t>(std::clamp(static_cast<int>(std::lround(at.y())), 0, image.rows - 1),
                                  std::clamp(static_cast<int>(std::lround(at.x())), 0, image.cols - 1));
  }
  return sum / kSamples;
}

/// Where along a ray the light falls to its half; `last` is the ray's last lit pixel. Empty: the light fades
/// over a long way instead of ending at once, so that there is no rim.
std::optional<Eigen::Vector2d> rim(const cv::Mat& image, Eigen::Vector2d last, const Eigen::Vector2d& step) {
  constexpr double kLeastDrop = 2.0;  // grey levels
  constexpr double kLeastOfLight = 0.5;
  const double unit = 0.005 * image.rows;
  const double outside = mean(image, last, step, unit, 3.0 * unit);
  const double inside = mean(image, last, step, -4.0 * unit, -unit);
  const double within = mean(image, last, step, -11.0 * unit, -8.0 * unit);
  if (inside - outside <= std::max(kLeastDrop, kLeastOfLight * (within - outside))) return std::nullopt;
  const double half = 0.5 * (outside + mean(image, last, step, -6.0 * unit, -3.0 * unit));
  for (double moved = 0.0; moved < 4.0 * unit && mean(image, last, step, 0.0, 0.0) < half; ++moved)
    last -= step;
  return last;
}

/// Where each ray from the middle leaves the light for good, at once, inside the picture.
std::vector<Eigen::Vector2d> edges(const cv::Mat& image, double dark) {
  const Eigen::Vector2d middle(0.5 * (image.cols - 1), 0.5 * (image.rows - 1));
  const int margin = margin_of(image);
  std::vector<Eigen::Vector2d> found;
  for (int k = 0; k < kRays; ++k) {
    const double angle = 2.0 * M_PI * k / kRays;
    const Eigen::Vector2d step(std::cos(angle), std::sin(angle));
    Eigen::Vector2d last = middle;
    double dark_beyond = 0.0, length = 0.0;
    for (Eigen::Vector2d p = middle;; p += step, ++length) {
      const int x = static_cast<int>(std::lround(p.x())), y = static_cast<int>(std::lround(p.y()));
      if (x < margin || y < margin || x >= image.cols - margin || y >= image.rows - margin) break;
      if (image.at<std::uint8_t>(y, x) > dark)
        last = p, dark_beyond = 0.0;
      else
        ++dark_beyond;
    }
    if (dark_beyond < 4.0 || dark_beyond > 0.9 * length) continue;
    if (const auto edge = rim(image, last, step)) found.push_back(*edge);
  }
  return found;
}

/// How far out a pixel lies: 1 on the circle.
double reach(const ScopeCircle& circle, const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d d = pixel - circle.centre;
  return std::hypot(d.x(), d.y() / circle.aspect) / circle.radius;
}

std::vector<Eigen::Vector2d> on_circle(const ScopeCircle& circle,
                                       const std::vector<Eigen::Vector2d>& points) {
  const double tolerance = std::max(1.5 / circle.radius, kOnCircle);
  std::vector<Eigen::Vector2d> result;
  for (const Eigen::Vector2d& p : points)
    if (std::abs(reach(circle, p) - 1.0) < tolerance) result.push_back(p);
  return result;
}

/// Least squares, algebraic: x^2 + k y^2 + a x + b y + c = 0, k = 1 for a circle.
std::optional<ScopeCircle> fitted(const std::vector<Eigen::Vector2d>& points, bool round) {
  if (points.size() < (round ? 3U : 4U)) return std::nullopt;
  // About their middle, in units of their spread: the sums of squares are of one size then.
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : points) middle += p / static_cast<double>(points.size());
  double spread = 1.0;
  for (const Eigen::Vector2d& p : points) spread = std::max(spread, (p - middle).norm());
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), round ? 3 : 4);
  Eigen::VectorXd right(rows.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Eigen::Vector2d p = (points[static_cast<std::size_t>(i)] - middle) / spread;
    rows(i, 0) = p.x(), rows(i, 1) = p.y(), rows(i, 2) = 1.0;
    if (!round) rows(i, 3) = p.y() * p.y();
    right[i] = -p.x() * p.x() - (round ? p.y() * p.y() : 0.0);
  }
  const Eigen::VectorXd s = rows.colPivHouseholderQr().solve(right);
  const double k = round ? 1.0 : s[3];
  if (!s.allFinite() || k <= 0.0) return std::nullopt;
  const Eigen::Vector2d centre(-0.5 * s[0], -0.5 * s[1] / k);
  const double square = centre.x() * centre.x() + k * centre.y() * centre.y() - s[2];
  if (square <= 0.0) return std::nullopt;
  return ScopeCircle{middle + spread * centre, spread * std::sqrt(square), 1.0 / std::sqrt(k)};
}

bool has_its_size(const ScopeCircle& circle, const cv::Mat& image) {
  const double height = circle.radius * circle.aspect;
  return circle.aspect > kLeastAspect && circle.aspect < kLargestAspect &&
         std::min(circle.radius, height) > 0.2 * image.rows &&
         std::max(circle.radius, height) < 1.2 * image.cols;
}

/// The circle, or the ellipse along the axes, that explains most points.
std::optional<ScopeCircle> best_through(const std::vector<Eigen::Vector2d>& points, const cv::Mat& image,
                                        bool round) {
  // Every third (or fourth) of the points a way round: enough samples to meet one without outliers, the same
  // on every run.
  std::optional<ScopeCircle> best;
  std::size_t most = 0;
  const std::size_t n = points.size(), wanted = round ? 3 : 4;
  for (std::size_t i = 0; i < n; ++i)
    for (const std::size_t step : {n / wanted, n / (wanted + 2), n / (3 * wanted)}) {
      std::vector<Eigen::Vector2d> sample;
      for (std::size_t k = 0; k < wanted; ++k) sample.push_back(points[(i + k * step) % n]);
      const auto circle = fitted(sample, round);
      if (!circle || !has_its_size(*circle, image)) continue;
      const std::size_t count = on_circle(*circle, points).size();
      if (count > most) most = count, best = circle;
    }
  for (int pass = 0; pass < 4 && best; ++pass) best = fitted(on_circle(*best, points), round);
  return best && has_its_size(*best, image) ? best : std::nullopt;
}

/// Widest angle between neighbours, seen from the centre.
double widest_gap(const ScopeCircle& circle, const std::vector<Eigen::Vector2d>& points) {
  std::vector<double> angles;
  angles.reserve(points.size());
  for (const Eigen::Vector2d& p : points)
    angles.push_back(std::atan2(p.y() - circle.centre.y(), p.x() - circle.centre.x()));
  std::sort(angles.begin(), angles.end());
  double widest = angles.front() + 2.0 * M_PI - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
  return widest;
}

/// Whether what lies outside is there, and dark.
bool dark_outside(const cv::Mat& image, const ScopeCircle& circle, double dark) {
  constexpr double kBlur = 1.03;
  const int margin = margin_of(image);
  double outside = 0.0, light = 0.0;
  for (int y = margin; y < image.rows - margin; ++y)
    for (int x = margin; x < image.cols - margin; ++x)
      if (reach(circle, {x, y}) > kBlur) ++outside, light += image.at<std::uint8_t>(y, x) > dark ? 1.0 : 0.0;
  return outside > kLeastOutside * static_cast<double>(image.total()) && light < kMostLight * outside;
}

}  // namespace

std::optional<ScopeCircle> find_scope_circle(const Picture& picture) {
  cv::Mat image;
  cv::medianBlur(grey(picture), image, 5);
  const auto dark = dark_level(image);
  if (!dark) return std::nullopt;
  const std::vector<Eigen::Vector2d> points = edges(image, *dark);
  const auto fewest =
      static_cast<std::size_t>(std::max(kLeastShare * kRays, kLeastOf * static_cast<double>(points.size())));
  if (points.size() < fewest) return std::nullopt;
  const auto count = [&](const std::optional<ScopeCircle>& circle) {
    return circle ? on_circle(*circle, points).size() : 0;
  };
  auto best = best_through(points, image, true);
  const auto ellipse = best_through(points, image, false);  // pixels are not square
  if (static_cast<double>(count(ellipse)) > kRounder * static_cast<double>(count(best))) best = ellipse;
  if (!best || count(best) < fewest) return std::nullopt;
  const std::vector<Eigen::Vector2d> rim = on_circle(*best, points);
  if (widest_gap(*best, rim) > kWidestGap || !dark_outside(image, *best, *dark)) return std::nullopt;
  return best;
}

Picture circle_mask(const ScopeCircle& circle, int width, int height, double margin_px) {
  require(width > 0 && height > 0 && circle.radius > 0.0 && circle.aspect > 0.0,
          "a mask has a size, and a circle a radius");
  cv::Mat mask = cv::Mat::zeros(height, width, CV_8U);
  const double x_axis = circle.radius - margin_px, y_axis = circle.radius * circle.aspect - margin_px;
  if (x_axis <= 0.0 || y_axis <= 0.0) return to_picture(mask);
  const ScopeCircle inner{circle.centre, x_axis, y_axis / x_axis};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (reach(inner, {x, y}) <= 1.0) mask.at<std::uint8_t>(y, x) = 255;
  return to_picture(mask);
}

}  // namespace glisson::stereo
