// SPDX-License-Identifier: GPL-3.0-or-later
#include "disparity_fit.h"

#include <Eigen/Dense>
#include <algorithm>
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
constexpr int kSide = 2 * kHalf + 1;
constexpr int kCount = kSide * kSide;
constexpr int kLanes = 16;  ///< a patch's row, and one place that stays empty
using Lanes = Eigen::Array<float, kLanes, 1>;

/// How far each lane lies right of the patch's middle, pixels; of the empty one zero.
const Lanes& across() {
  static const Lanes kAcross = [] {
    Lanes lanes = Lanes::Zero();
    for (int i = 0; i < kSide; ++i) lanes[i] = static_cast<float>(i - kHalf);
    return lanes;
  }();
  return kAcross;
}

/// The left picture's patch, its grey levels about their mean: single precision is enough then.
struct LeftPatch {
  Lanes rows[kSide];
  float mean = 0.0F;
  double squares = 0.0;

  LeftPatch(const cv::Mat& left, int x, int y) {
    int sum = 0;
    for (int j = 0; j < kSide; ++j)
      for (int i = 0; i < kSide; ++i) sum += left.ptr<std::uint8_t>(y + j - kHalf)[x + i - kHalf];
    mean = static_cast<float>(sum) / kCount;
    for (int j = 0; j < kSide; ++j) {
      rows[j].setZero();
      const auto* l = left.ptr<std::uint8_t>(y + j - kHalf) + x - kHalf;
      for (int i = 0; i < kSide; ++i) rows[j][i] = l[i] - mean;
      squares += rows[j].square().sum();
    }
  }
};

/// Sums over the patch about one state of the fit, column by column: s is the right picture's slope, v its
/// value, e the residual, l the left picture's value, j the row.
struct Sums {
  Lanes ss = Lanes::Zero(), ssj = ss, ssjj = ss, sv = ss, svj = ss, s = ss, sj = ss, vv = ss, v = ss, se = ss,
        sej = ss, ve = ss, e = ss, ee = ss, lv = ss;

  void add(float j, const Lanes& slope, const Lanes& value, const Lanes& residual, const Lanes& left) {
    const Lanes slope2 = slope * slope, both = slope * value, off = slope * residual;
    ss += slope2, ssj += j * slope2, ssjj += (j * j) * slope2;
    sv += both, svj += j * both;
    s += slope, sj += j * slope;
    vv += value * value, v += value;
    se += off, sej += j * off;
    ve += value * residual, e += residual, ee += residual * residual, lv += left * value;
  }
  static double sum(const Lanes& lanes) { return lanes.cast<double>().sum(); }
  static double moment(const Lanes& lanes) { return sum(lanes * across()); }

  /// Of the unknowns disparity, its slopes, gain and offset.
  Matrix5 normal(double gain) const {
    Matrix5 all;
    all(0, 0) = sum(ss), all(0, 1) = moment(ss), all(0, 2) = sum(ssj);
    all(1, 1) = moment(ss * across()), all(1, 2) = moment(ssj), all(2, 2) = sum(ssjj);
    all.topLeftCorner<3, 3>() *= gain * gain;
    all(0, 3) = -gain * sum(sv), all(1, 3) = -gain * moment(sv), all(2, 3) = -gain * sum(svj);
    all(0, 4) = -gain * sum(s), all(1, 4) = -gain * moment(s), all(2, 4) = -gain * sum(sj);
    all(3, 3) = sum(vv), all(3, 4) = sum(v), all(4, 4) = kCount;
    return all.selfadjointView<Eigen::Upper>();
  }
  Vector5 side(double gain) const {
    Vector5 all;
    all << -gain * sum(se), -gain * moment(se), -gain * sum(sej), sum(ve), sum(e);
    return all;
  }
  double correlation(const LeftPatch& left) const {
    const double right = sum(v), rr = sum(vv) - right * right / kCount;
    return left.squares > 0.0 && rr > 0.0 ? sum(lv) / std::sqrt(left.squares * rr) : 0.0;
  }
};

/// Disparity, its slope along x and y, gain, offset: of grey levels less the left patch's mean.
struct State {
  double disparity, slope_x = 0.0, slope_y = 0.0, gain = 1.0, offset = 0.0;
  void step(const Vector5& by) {
    disparity += by[0], slope_x += by[1], slope_y += by[2], gain += by[3], offset += by[4];
  }
};

/// @return false: the patch leaves the right picture.
bool look(const LeftPatch& patch, const cv::Mat& right, int x, int y, const State& state, Sums& sums) {
  const double step = 1.0 - state.slope_x;
  for (int j = -kHalf; j <= kHalf; ++j) {
    const auto* r = right.ptr<std::uint8_t>(y + j);
    const double middle = x - state.disparity - state.slope_y * j;
    const double first = middle - kHalf * step, last = middle + kHalf * step;
    if (!(std::min(first, last) >= 1.0 && std::max(first, last) < right.cols - 2)) return false;
    Lanes before = Lanes::Zero(), here = before, next = before, after = before, part = before;
    for (int i = 0; i < kSide; ++i) {
      const double u = middle + (i - kHalf) * step;
      const int whole = static_cast<int>(u);
      const auto* at = r + whole;
      part[i] = static_cast<float>(u - whole);
      before[i] = at[-1], here[i] = at[0], next[i] = at[1], after[i] = at[2];
    }
    const Lanes& left = patch.rows[j + kHalf];
    Lanes value = here + part * (next - here) - patch.mean;
    value[kSide] = 0.0F;
    const Lanes slope = 0.5F * ((next - before) + part * ((after - here) - (next - before)));
    Lanes residual = left - static_cast<float>(state.gain) * value - static_cast<float>(state.offset);
    residual[kSide] = 0.0F;
    sums.add(static_cast<float>(j), slope, value, residual, left);
  }
  return true;
}

}  // namespace

std::optional<FittedDisparity> fit_disparity(const cv::Mat& left, const cv::Mat& right, int x, int y,
                                             double start) {
  if (x < kHalf || y < kHalf || x + kHalf >= left.cols || y + kHalf >= left.rows) return std::nullopt;
  const LeftPatch patch(left, x, y);
  State state{start};
  for (int step = 0;; ++step) {
    Sums sums;
    if (!look(patch, right, x, y, state, sums)) return std::nullopt;
    const auto solver = sums.normal(state.gain).ldlt();
    const Vector5 change = solver.solve(sums.side(state.gain));
    if (!change.allFinite()) return std::nullopt;
    if (step < kMostSteps && std::abs(change[0]) > kSmall) {
      state.step(change);
      if (std::abs(state.disparity - start) > 2.0 * kFarthest) return std::nullopt;  // it may overshoot
      continue;
    }
    const double noise = Sums::sum(sums.ee) / (kCount - 5.0);
    const double variance = solver.solve(Vector5::Unit(0))[0] * noise;
    if (std::abs(state.disparity - start) > kFarthest || !(variance >= 0.0) ||
        variance > kMostSigma * kMostSigma || sums.correlation(patch) < kLeastCorrelation)
      return std::nullopt;
    return FittedDisparity{state.disparity, std::sqrt(variance)};
  }
}

}  // namespace glisson::guidance
