// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine.h"

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

namespace glisson::stereo {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

// Standard deviations before anything is seen: slope of the disparity (a surface at 60 degrees to the view),
// rows (calibration), gain and offset (vignetting of two lenses).
constexpr double kSlopePrior = 0.12, kRowPrior = 0.7, kGainPrior = 0.3, kOffsetPrior = 40.0;
// Residuals of neighbouring pixels are alike (sensor, warp and blur mix them): fewer are independent than are
// counted. Measured on rendered pairs of known depth: see the module's README.
constexpr double kCorrelation = 1.4;
constexpr double kLeastNoise = 1.0;        // grey levels
constexpr double kLeastCorrelation = 0.7;  // of the patches
constexpr double kSigmaFloor = 0.03;       // pixels: interpolation

/// Bilinear. @pre inside the image by a pixel.
float sample(const cv::Mat& image, double x, double y) {
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const auto fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
  const float* upper = image.ptr<float>(y0) + x0;
  const float* lower = image.ptr<float>(y0 + 1) + x0;
  const float top = upper[0] + fx * (upper[1] - upper[0]);
  return top + fy * (lower[0] + fx * (lower[1] - lower[0]) - top);
}

bool inside(const cv::Mat& image, double x, double y) {
  return x >= 1.0 && y >= 1.0 && x < image.cols - 2.0 && y < image.rows - 2.0;
}

}  // namespace

struct Refiner::Patch {
  Eigen::Vector2d centre;
  std::vector<Eigen::Vector2d> offsets;
  std::vector<double> values, weights;
};

struct Refiner::State {
  double disparity = 0.0, slope_x = 0.0, slope_y = 0.0, row = 0.0, gain = 1.0, offset = 0.0;
  double expected_row = 0.0;
  double sigma = 1.0, correlation = 0.0;
};

Refiner::Refiner(const Rectification& rectification, const cv::Mat& left, const cv::Mat& right,
                 const cv::Mat& excluded, int half_width)
    : rectification_(rectification), excluded_(excluded), half_width_(half_width) {
  // The same slight blur on both: bilinear interpolation of sharp pixels is biased.
  constexpr double kBlur = 0.7;
  left.convertTo(left_, CV_32F);
  right.convertTo(right_, CV_32F);
  cv::GaussianBlur(left_, left_, cv::Size(), kBlur);
  cv::GaussianBlur(right_, right_, cv::Size(), kBlur);
  const cv::Mat kernel = (cv::Mat_<float>(1, 3) << -0.5F, 0.0F, 0.5F);
  cv::filter2D(right_, right_dx_, CV_32F, kernel);
  cv::filter2D(right_, right_dy_, CV_32F, kernel.t());
}

bool Refiner::sample_left(const Eigen::Vector2d& centre, Patch& patch) const {
  patch.centre = centre;
  const double spread = 0.6 * half_width_;
  int excluded = 0;
  for (int y = -half_width_; y <= half_width_; ++y)
    for (int x = -half_width_; x <= half_width_; ++x) {
      const double px = centre.x() + x, py = centre.y() + y;
      if (!inside(left_, px, py)) return false;
      if (excluded_.at<std::uint8_t>(static_cast<int>(std::lround(py)), static_cast<int>(std::lround(px)))) {
        ++excluded;
        continue;
      }
      patch.offsets.emplace_back(x, y);
      patch.values.push_back(sample(left_, px, py));
      patch.weights.push_back(std::exp(-(x * x + y * y) / (2.0 * spread * spread)));
    }
  return 2 * excluded < (2 * half_width_ + 1) * (2 * half_width_ + 1);
}

/// The whole-pixel shift around the start with the least difference, light removed.
double Refiner::search(const Patch& patch, const Match& start, double row) const {
  constexpr int kReach = 3;
  const double disparity = rectification_.disparity(start.left, start.right);
  double best = disparity, best_score = -2.0;
  for (int shift = -kReach; shift <= kReach; ++shift) {
    double n = 0, sl = 0, sr = 0, sll = 0, srr = 0, slr = 0;
    for (std::size_t k = 0; k < patch.offsets.size(); ++k) {
      const double x =
          rectification_.right_column(patch.centre.x(), disparity + shift) + patch.offsets[k].x();
      const double y = patch.centre.y() + row + patch.offsets[k].y();
      if (!inside(right_, x, y)) continue;
      const double l = patch.values[k], r = sample(right_, x, y), w = patch.weights[k];
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
  Matrix6 normal = Matrix6::Zero(), spread = Matrix6::Zero();
  Vector6 right_side = Vector6::Zero();
  double n = 0, sum = 0, sl = 0, sr = 0, sll = 0, srr = 0, slr = 0;
  for (std::size_t k = 0; k < patch.offsets.size(); ++k) {
    const Eigen::Vector2d& o = patch.offsets[k];
    const double x = rectification_.right_column(patch.centre.x(), s.disparity) + o.x() - s.slope_x * o.x() -
                     s.slope_y * o.y();
    const double y = patch.centre.y() + s.row + o.y();
    if (!inside(right_, x, y)) return std::nullopt;
    const double r = sample(right_, x, y), gx = s.gain * sample(right_dx_, x, y),
                 gy = s.gain * sample(right_dy_, x, y), w = patch.weights[k], l = patch.values[k];
    const double residual = l - (s.gain * r + s.offset);
    Vector6 j;
    j << -gx, -gx * o.x(), -gx * o.y(), gy, r, 1.0;
    normal.noalias() += w * j * j.transpose();
    spread.noalias() += w * w * j * j.transpose();
    right_side += w * residual * j;
    sum += w * residual * residual;
    n += w, sl += w * l, sr += w * r, sll += w * l * l, srr += w * r * r, slr += w * l * r;
  }
  const double noise = std::max(kLeastNoise * kLeastNoise, sum / n);
  Vector6 prior;
  prior << 1e-9, noise / (kSlopePrior * kSlopePrior), noise / (kSlopePrior * kSlopePrior),
      noise / (kRowPrior * kRowPrior), noise / (kGainPrior * kGainPrior),
      noise / (kOffsetPrior * kOffsetPrior);
  Vector6 held;
  held << 0.0, s.slope_x, s.slope_y, s.row - s.expected_row, s.gain - 1.0, s.offset;
  normal.diagonal() += prior;
  const Eigen::LDLT<Matrix6> factor(normal);
  const Vector6 step = factor.solve(right_side - prior.cwiseProduct(held));
  if (!step.allFinite()) return std::nullopt;
  s.disparity += step[0];
  s.slope_x += step[1];
  s.slope_y += step[2];
  s.row += step[3];
  s.gain += step[4];
  s.offset += step[5];
  const Vector6 column = factor.solve(Vector6::Unit(0));
  s.sigma = std::sqrt(kCorrelation * kCorrelation * noise * column.dot(spread * column) +
                      kSigmaFloor * kSigmaFloor);
  const double variance = (sll - sl * sl / n) * (srr - sr * sr / n);
  s.correlation = variance > 0.0 ? (slr - sl * sr / n) / std::sqrt(variance) : 0.0;
  return step[0];
}

std::optional<Match> Refiner::refine(const Match& start, double row) const {
  Patch patch;
  if (!sample_left(start.left, patch)) return std::nullopt;
  State state;
  const double first = search(patch, start, row);
  state.disparity = first;
  state.row = state.expected_row = row;
  for (int pass = 0; pass < 30; ++pass) {
    const auto change = iterate(patch, state);
    if (!change || std::abs(state.disparity - first) > 2.0 || std::abs(state.slope_x) > 0.5 ||
        std::abs(state.slope_y) > 0.5)
      return std::nullopt;
    if (std::abs(*change) > 0.01) continue;
    if (state.correlation < kLeastCorrelation) return std::nullopt;
    Match refined = start;
    refined.right = {rectification_.right_column(start.left.x(), state.disparity),
                     start.left.y() + state.row};
    refined.sigma = state.sigma;
    return refined;
  }
  return std::nullopt;
}

}  // namespace glisson::stereo
