// SPDX-License-Identifier: GPL-3.0-or-later
#include "disparity_fit.h"

#include <Eigen/Dense>
#include <cmath>

namespace glisson::guidance {
namespace {

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

constexpr int kHalf = 7;                   ///< of the patch's width, pixels
constexpr int kMostSteps = 4;              ///< from within a pixel it is there after three
constexpr double kSmall = 0.02;            ///< pixels: a step that changes nothing
constexpr double kFarthest = 1.0;          ///< pixels from where it was looked for
constexpr double kMostSigma = 0.5;         ///< pixels
constexpr double kLeastCorrelation = 0.5;  ///< half of the variance is in both pictures
constexpr int kCount = (2 * kHalf + 1) * (2 * kHalf + 1);

/// Sums over the patch about one state of the fit.
struct Sums {
  Matrix5 normal = Matrix5::Zero();
  Vector5 side = Vector5::Zero();
  double squares = 0.0;                                                   ///< of the residuals
  double left = 0.0, right = 0.0, left2 = 0.0, right2 = 0.0, both = 0.0;  ///< of the grey levels
  void add(const Vector5& row, double residual, double l, double r) {
    normal += row * row.transpose();
    side += row * residual;
    squares += residual * residual;
    left += l, right += r, left2 += l * l, right2 += r * r, both += l * r;
  }
  double correlation() const {
    const double ll = left2 - left * left / kCount, rr = right2 - right * right / kCount;
    return ll > 0.0 && rr > 0.0 ? (both - left * right / kCount) / std::sqrt(ll * rr) : 0.0;
  }
};

/// Disparity, its slope along x and y, gain, offset.
struct State {
  double disparity, slope_x = 0.0, slope_y = 0.0, gain = 1.0, offset = 0.0;
  void step(const Vector5& by) {
    disparity += by[0], slope_x += by[1], slope_y += by[2], gain += by[3], offset += by[4];
  }
};

/// @return false: the patch leaves the right picture.
bool look(const cv::Mat& left, const cv::Mat& right, int x, int y, const State& state, Sums& sums) {
  for (int j = -kHalf; j <= kHalf; ++j) {
    const auto* l = left.ptr<std::uint8_t>(y + j) + x;
    const auto* r = right.ptr<std::uint8_t>(y + j);
    for (int i = -kHalf; i <= kHalf; ++i) {
      const double u = x + i - (state.disparity + state.slope_x * i + state.slope_y * j);
      const double whole = std::floor(u), part = u - whole;
      if (!(whole >= 1.0 && whole + 2.0 < right.cols)) return false;
      const auto* at = r + static_cast<int>(whole);
      const double value = (1.0 - part) * at[0] + part * at[1];
      const double slope = 0.5 * ((1.0 - part) * (at[1] - at[-1]) + part * (at[2] - at[0]));
      Vector5 row;
      row << -state.gain * slope, -state.gain * slope * i, -state.gain * slope * j, value, 1.0;
      sums.add(row, l[i] - state.gain * value - state.offset, l[i], value);
    }
  }
  return true;
}

}  // namespace

std::optional<FittedDisparity> fit_disparity(const cv::Mat& left, const cv::Mat& right, int x, int y,
                                             double start) {
  if (x < kHalf || y < kHalf || x + kHalf >= left.cols || y + kHalf >= left.rows) return std::nullopt;
  State state{start};
  for (int step = 0;; ++step) {
    Sums sums;
    if (!look(left, right, x, y, state, sums)) return std::nullopt;
    const auto solver = sums.normal.ldlt();
    const Vector5 change = solver.solve(sums.side);
    if (!change.allFinite()) return std::nullopt;
    if (step < kMostSteps && std::abs(change[0]) > kSmall) {
      state.step(change);
      if (std::abs(state.disparity - start) > 2.0 * kFarthest) return std::nullopt;  // it may overshoot
      continue;
    }
    const double noise = sums.squares / (kCount - 5.0);
    const double variance = solver.solve(Vector5::Unit(0))[0] * noise;
    if (std::abs(state.disparity - start) > kFarthest || !(variance >= 0.0) ||
        variance > kMostSigma * kMostSigma || sums.correlation() < kLeastCorrelation)
      return std::nullopt;
    return FittedDisparity{state.disparity, std::sqrt(variance)};
  }
}

}  // namespace glisson::guidance
