// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "sampling.h"

#include "glisson/core/statistics.h"

namespace glisson::stereo {
namespace {

enum Unknown { kDisparity, kSlopeX, kSlopeY, kRow, kGain, kOffset, kBendXX, kBendXY, kBendYY, kUnknowns };
using Vector = Eigen::Matrix<double, kUnknowns, 1>;
using Matrix = Eigen::Matrix<double, kUnknowns, kUnknowns>;

// Priors' standard deviations: slope of the disparity (a surface at 60 degrees to the view), difference of
// rows (calibration), gain and offset of light (vignetting of two lenses). That of the bend is
// Rectification::bend_prior().
constexpr double kSlopePrior = 0.12, kRowPrior = 0.7, kGainPrior = 0.3, kOffsetPrior = 40.0;
constexpr double kLeastNoise = 0.3;        // grey levels: what eight bits leave
constexpr double kLeastCorrelation = 0.7;  // of the patches
constexpr double kSigmaFloor = 0.01;       // pixels: interpolation
constexpr double kBlur = 0.7;              // pixels: removes what would be interpolated badly
/// Pixels. Neighbouring residuals are correlated as white noise is after a blur of this width: the blur
/// above, the warp and the sampling of the patch together.
constexpr double kAlike = 1.0;
constexpr double kTukey = 4.7;  // of the residuals' deviation; beyond it is a highlight, no tissue

}  // namespace

struct Refiner::Patch {
  Eigen::Vector2i centre;
  std::vector<Eigen::Vector2d> offsets;
  std::vector<double> values, weights, dx, dy;  ///< dx, dy: gradient of the left picture
};

struct Refiner::State {
  Vector unknowns = Vector::Unit(kGain);
  double expected_row = 0.0;
  double scale = 0.0;        ///< deviation of the residuals, robust; 0: not known yet
  double correlation = 0.0;  ///< of the patches
  // Of the last step, for sigma():
  Eigen::LDLT<Matrix> factor;
  Vector prior = Vector::Zero();
  double noise = 0.0;
  std::vector<Vector> rows;
  std::vector<double> weights;
};

Refiner::Refiner(const Rectification& rectification, const cv::Mat& left, const cv::Mat& right,
                 const cv::Mat& excluded_left, const cv::Mat& excluded_right, int half_width)
    : rectification_(rectification),
      excluded_left_(excluded_left),
      excluded_right_(excluded_right),
      half_width_(half_width) {
  left.convertTo(left_, CV_32F);
  right.convertTo(right_, CV_32F);
  cv::GaussianBlur(left_, left_, cv::Size(), kBlur);
  cv::GaussianBlur(right_, right_, cv::Size(), kBlur);
  const cv::Mat kernel = (cv::Mat_<float>(1, 3) << -0.5F, 0.0F, 0.5F);
  cv::filter2D(left_, left_dx_, CV_32F, kernel);
  cv::filter2D(left_, left_dy_, CV_32F, kernel.t());
}

double Refiner::reach() const { return 0.6 * half_width_; }

bool Refiner::sample_left(const Eigen::Vector2d& centre, Patch& patch) const {
  patch.centre = {static_cast<int>(std::lround(centre.x())), static_cast<int>(std::lround(centre.y()))};
  const double spread = reach();
  int excluded = 0;
  for (int y = -half_width_; y <= half_width_; ++y)
    for (int x = -half_width_; x <= half_width_; ++x) {
      const int px = patch.centre.x() + x, py = patch.centre.y() + y;
      if (px < 0 || py < 0 || px >= left_.cols || py >= left_.rows) return false;
      if (excluded_left_.at<std::uint8_t>(py, px)) {
        ++excluded;
        continue;
      }
      patch.offsets.emplace_back(x, y);
      patch.values.push_back(left_.at<float>(py, px));
      patch.dx.push_back(left_dx_.at<float>(py, px));
      patch.dy.push_back(left_dy_.at<float>(py, px));
      patch.weights.push_back(std::exp(-(x * x + y * y) / (2.0 * spread * spread)));
    }
  return 2 * excluded < (2 * half_width_ + 1) * (2 * half_width_ + 1);
}

/// The whole-pixel shift around the start with the least difference, light removed.
double Refiner::search(const Patch& patch, double disparity, double row) const {
  constexpr int kReach = 3;
  double best = disparity, best_score = -2.0;
  for (int shift = -kReach; shift <= kReach; ++shift) {
    double n = 0, sl = 0, sr = 0, sll = 0, srr = 0, slr = 0;
    for (std::size_t k = 0; k < patch.offsets.size(); ++k) {
      const double x =
          rectification_.right_column(patch.centre.x(), disparity + shift) + patch.offsets[k].x();
      const double y = patch.centre.y() + row + patch.offsets[k].y();
      if (!inside_cubic(right_, x, y)) continue;
      const double l = patch.values[k], w = patch.weights[k],
                   r = right_.at<float>(static_cast<int>(std::lround(y)), static_cast<int>(std::lround(x)));
      n += w, sl += w * l, sr += w * r, sll += w * l * l, srr += w * r * r, slr += w * l * r;
    }
    if (n <= 0.0) continue;
    const double variance = (sll - sl * sl / n) * (srr - sr * sr / n);
    const double score = variance > 0.0 ? (slr - sl * sr / n) / std::sqrt(variance) : -1.0;
    if (score > best_score) best_score = score, best = disparity + shift;
  }
  return best;
}

/// One step. @return the change of the disparity; empty when the patch leaves the image.
std::optional<double> Refiner::iterate(const Patch& patch, State& s) const {
  const Vector& u = s.unknowns;
  const std::size_t count = patch.offsets.size();
  Matrix normal = Matrix::Zero();
  Vector right_side = Vector::Zero();
  s.rows.resize(count);
  s.weights.resize(count);
  std::vector<double> sizes(count);
  double n = 0, sum = 0, sl = 0, sr = 0, sll = 0, srr = 0, slr = 0, all = 0, shown = 0;
  const double column = rectification_.right_column(patch.centre.x(), u[kDisparity]);
  for (std::size_t k = 0; k < count; ++k) {
    const double ox = patch.offsets[k].x(), oy = patch.offsets[k].y();
    const double change = u[kSlopeX] * ox + u[kSlopeY] * oy + u[kBendXX] * ox * ox + u[kBendXY] * ox * oy +
                          u[kBendYY] * oy * oy;
    const double x = column + ox - change, y = patch.centre.y() + u[kRow] + oy;
    if (!inside_cubic(right_, x, y)) return std::nullopt;
    const double r = sample_cubic(right_, x, y), l = patch.values[k];
    const double residual = l - (u[kGain] * r + u[kOffset]);
    sizes[k] = std::abs(residual);
    // The right picture's gradient, times the gain, by the left one's: between pixels, interpolation mixes
    // the noise of values and of gradients, which would draw matches to certain fractions of a pixel.
    const double along = 1.0 - u[kSlopeX] - 2.0 * u[kBendXX] * ox - u[kBendXY] * oy,
                 across = u[kSlopeY] + u[kBendXY] * ox + 2.0 * u[kBendYY] * oy;
    const double gx = patch.dx[k] / along, gy = patch.dy[k] + across * gx;
    s.rows[k] << -gx, -gx * ox, -gx * oy, gy, l, 1.0, -gx * ox * ox, -gx * ox * oy, -gx * oy * oy;
    const bool hidden = excluded_right_.at<std::uint8_t>(static_cast<int>(std::lround(y)),
                                                         static_cast<int>(std::lround(x))) != 0;
    all += patch.weights[k];
    if (!hidden) shown += patch.weights[k];
    const double t = s.scale > 0.0 ? residual / (kTukey * s.scale) : 0.0;
    const double w = hidden || std::abs(t) >= 1.0 ? 0.0 : patch.weights[k] * (1.0 - t * t) * (1.0 - t * t);
    s.weights[k] = w;
    normal.noalias() += w * s.rows[k] * s.rows[k].transpose();
    right_side += w * residual * s.rows[k];
    sum += w * residual * residual;
    n += w, sl += w * l, sr += w * r, sll += w * l * l, srr += w * r * r, slr += w * l * r;
  }
  if (2.0 * shown < all || !(n > 0.0)) return std::nullopt;
  s.noise = std::max(kLeastNoise * kLeastNoise, sum / n);
  s.scale = std::max(kLeastNoise, kDeviationPerMad * upper_median(std::move(sizes)));
  const double bend = rectification_.bend_prior();
  Vector deviations;
  deviations << 1e5, kSlopePrior, kSlopePrior, kRowPrior, kGainPrior, kOffsetPrior, bend, bend, bend;
  s.prior = s.noise * deviations.cwiseAbs2().cwiseInverse();
  Vector held = u;
  held[kDisparity] = 0.0;
  held[kRow] -= s.expected_row;
  held[kGain] -= 1.0;
  normal.diagonal() += s.prior;
  s.factor.compute(normal);
  const Vector step = s.factor.solve(right_side - s.prior.cwiseProduct(held));
  if (!step.allFinite()) return std::nullopt;
  s.unknowns += step;
  const double variance = (sll - sl * sl / n) * (srr - sr * sr / n);
  s.correlation = variance > 0.0 ? (slr - sl * sr / n) / std::sqrt(variance) : 0.0;
  return step[kDisparity];
}

/// Standard deviation of the disparity, pixels: each pixel's influence on it times the noise that the
/// residuals show, plus what the priors leave open.
double Refiner::sigma(const Patch& patch, const State& s) const {
  const Vector first = s.factor.solve(Vector::Unit(kDisparity));
  const int room = static_cast<int>(std::ceil(4.0 * kAlike)), side = 2 * (half_width_ + room) + 1;
  cv::Mat influence = cv::Mat::zeros(side, side, CV_32F);
  for (std::size_t k = 0; k < s.rows.size(); ++k)
    influence.at<float>(static_cast<int>(patch.offsets[k].y()) + half_width_ + room,
                        static_cast<int>(patch.offsets[k].x()) + half_width_ + room) =
        static_cast<float>(s.weights[k] * s.rows[k].dot(first));
  // White noise blurred to the same variance: the influence blurred likewise and divided by the blur's norm.
  cv::GaussianBlur(influence, influence, cv::Size(), kAlike, kAlike, cv::BORDER_CONSTANT);
  const double seen = influence.dot(influence) * 4.0 * std::numbers::pi * kAlike * kAlike;
  const double open = s.prior.tail<kUnknowns - 1>().dot(first.tail<kUnknowns - 1>().cwiseAbs2());
  return std::sqrt(s.noise * (seen + open) + kSigmaFloor * kSigmaFloor);
}

std::optional<Match> Refiner::refine(const Match& start, double row) const {
  constexpr int kPasses = 30;
  constexpr double kFarthest = 2.0, kSteepest = 0.5, kSettled = 0.005;
  Patch patch;
  if (!sample_left(start.left, patch)) return std::nullopt;
  const Eigen::Vector2d centre = patch.centre.cast<double>();
  State state;
  Vector& u = state.unknowns;
  const double first = search(patch, rectification_.disparity(start.left, start.right), row);
  u[kDisparity] = first;
  u[kRow] = state.expected_row = row;
  for (int pass = 0; pass < kPasses; ++pass) {
    const auto change = iterate(patch, state);
    if (!change || std::abs(u[kDisparity] - first) > kFarthest || std::abs(u[kSlopeX]) > kSteepest ||
        std::abs(u[kSlopeY]) > kSteepest)
      return std::nullopt;
    if (std::abs(*change) > kSettled) continue;
    if (state.correlation < kLeastCorrelation) return std::nullopt;
    return Match{centre,
                 {rectification_.right_column(centre.x(), u[kDisparity]), centre.y() + u[kRow]},
                 sigma(patch, state)};
  }
  return std::nullopt;
}

}  // namespace glisson::stereo
