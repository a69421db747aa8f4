// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch.h"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace glisson::guidance {
namespace {

constexpr int kWindow = 8;  ///< pixels of the picture to each side that are compared
constexpr int kSteps = 15;
constexpr double kStill = 0.01;  ///< pixels; a smaller step is none
/// Of the window, what the patch must show.
constexpr double kLeastShown = 0.7;
/// Squared grey levels: what varies less has no place.
constexpr double kPlain = 1.0;

/// Between four values of `side` a row. @pre 0 <= x, y < side - 1.
double between(const std::uint8_t* values, std::size_t side, double x, double y) {
  const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
  const double fx = x - static_cast<double>(column), fy = y - static_cast<double>(row);
  const std::uint8_t* low = values + row * side + column;
  const std::uint8_t* high = low + side;
  return (1.0 - fy) * ((1.0 - fx) * low[0] + fx * low[1]) + fy * ((1.0 - fx) * high[0] + fx * high[1]);
}

/// @pre is_within(grey, at, reach).
double grey_at(const cv::Mat& grey, double x, double y) { return between(grey.data, grey.step, x, y); }

bool is_within(const cv::Mat& grey, const Eigen::Vector2d& at, double reach) {
  return at.x() >= reach && at.y() >= reach && at.x() + reach < grey.cols - 1.0 &&
         at.y() + reach < grey.rows - 1.0;
}

/// The patch as it should look in the picture: places of the window, values less their mean, slopes.
struct Template {
  std::vector<Eigen::Vector2d> places, slopes;
  std::vector<double> values;
  double length = 0.0;  ///< root of the sum of squared values
  Eigen::Matrix2d inverse = Eigen::Matrix2d::Zero();
};

std::optional<Template> template_of(const Patch& patch, const Eigen::Matrix2d& picture_from_patch) {
  const Eigen::Matrix2d back = picture_from_patch.inverse();
  if (!back.allFinite()) return std::nullopt;
  // Of the window and what lies around it; not a number outside of the patch.
  constexpr int kAround = 2 * (kWindow + 1) + 1;
  std::array<double, std::size_t{kAround} * kAround> values{};
  for (int y = -kWindow - 1; y <= kWindow + 1; ++y)
    for (int x = -kWindow - 1; x <= kWindow + 1; ++x) {
      const Eigen::Vector2d in_patch =
          (back * Eigen::Vector2d(x, y)).array() + static_cast<double>(Patch::kReach);
      const bool is_in = in_patch.minCoeff() >= 0.0 && in_patch.maxCoeff() < Patch::kSide - 1.0;
      values[static_cast<std::size_t>((y + kWindow + 1) * kAround + x + kWindow + 1)] =
          is_in ? between(patch.grey.data(), Patch::kSide, in_patch.x(), in_patch.y())
                : std::numeric_limits<double>::quiet_NaN();
    }
  Template made;
  double mean = 0.0;
  for (int y = -kWindow; y <= kWindow; ++y)
    for (int x = -kWindow; x <= kWindow; ++x) {
      const double* here = values.data() + (y + kWindow + 1) * kAround + x + kWindow + 1;
      const double across = here[1] - here[-1], down = here[kAround] - here[-kAround];
      if (std::isnan(*here) || std::isnan(across) || std::isnan(down)) continue;
      made.places.emplace_back(x, y);
      made.values.push_back(*here);
      made.slopes.emplace_back(0.5 * across, 0.5 * down);
      mean += *here;
    }
  const auto n = static_cast<double>(made.values.size());
  if (n < kLeastShown * (2 * kWindow + 1) * (2 * kWindow + 1)) return std::nullopt;
  mean /= n;
  Eigen::Vector2d mean_slope = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& slope : made.slopes) mean_slope += slope / n;
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  double sum = 0.0;
  for (std::size_t i = 0; i < made.values.size(); ++i) {
    made.values[i] -= mean;
    made.slopes[i] -= mean_slope;  // brightness is free
    sum += made.values[i] * made.values[i];
    squares += made.slopes[i] * made.slopes[i].transpose();
  }
  if (sum < n * kPlain || squares.determinant() <= 1e-6 * squares.trace() * squares.trace())
    return std::nullopt;
  made.length = std::sqrt(sum);
  made.inverse = squares.inverse();
  return made;
}

}  // namespace

std::optional<Patch> patch_at(const cv::Mat& grey, const Eigen::Vector2d& at) {
  if (!is_within(grey, at, Patch::kReach + 1.0)) return std::nullopt;
  Patch patch;
  for (int y = 0; y < Patch::kSide; ++y)
    for (int x = 0; x < Patch::kSide; ++x)
      patch.grey[static_cast<std::size_t>(y * Patch::kSide + x)] = static_cast<std::uint8_t>(
          std::lround(grey_at(grey, at.x() + x - Patch::kReach, at.y() + y - Patch::kReach)));
  return patch;
}

std::optional<PatchFound> find_patch(const cv::Mat& grey, const Patch& patch,
                                     const Eigen::Matrix2d& picture_from_patch, const Eigen::Vector2d& guess,
                                     double most) {
  const std::optional<Template> wanted = template_of(patch, picture_from_patch);
  if (!wanted) return std::nullopt;
  PatchFound found{guess, -1.0};
  std::vector<double> seen(wanted->values.size());
  for (int step = 0;; ++step) {
    if (!is_within(grey, found.at, kWindow + 1.0)) return std::nullopt;
    double mean = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const Eigen::Vector2d at = found.at + wanted->places[i];
      seen[i] = grey_at(grey, at.x(), at.y());
      mean += seen[i] / static_cast<double>(seen.size());
    }
    double squares = 0.0, common = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      seen[i] -= mean;
      squares += seen[i] * seen[i];
      common += seen[i] * wanted->values[i];
    }
    if (squares < kPlain * static_cast<double>(seen.size())) return std::nullopt;
    found.likeness = common / (std::sqrt(squares) * wanted->length);
    if (step == kSteps) break;
    const double gain = wanted->length / std::sqrt(squares);
    Eigen::Vector2d side = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < seen.size(); ++i)
      side += (gain * seen[i] - wanted->values[i]) * wanted->slopes[i];
    const Eigen::Vector2d change = wanted->inverse * side;
    if (change.norm() < kStill) break;
    found.at -= change;
    if ((found.at - guess).norm() > most) return std::nullopt;
  }
  return found;
}

}  // namespace glisson::guidance
