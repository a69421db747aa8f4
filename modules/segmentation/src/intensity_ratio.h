// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace glisson::segmentation {

/// How often each intensity was seen. HU.
class IntensityHistogram {
 public:
  void add(float intensity, double weight = 1.0) { counts_[bin(intensity)] += weight; }

  /// Each bin's share, smoothed by 1.2 HU; they sum to 1.
  std::vector<double> shares() const {
    std::vector<double> h = counts_;
    for (int pass = 0; pass < 3; ++pass) {
      std::vector<double> next = h;
      for (std::size_t b = 1; b + 1 < h.size(); ++b) next[b] = 0.25 * h[b - 1] + 0.5 * h[b] + 0.25 * h[b + 1];
      h.swap(next);
    }
    double sum = 0.0;
    for (const double v : h) sum += v;
    for (double& v : h) v /= sum;
    return h;
  }
  static std::size_t bin(float v) { return static_cast<std::size_t>(std::clamp(v + 150.0F, 0.0F, 399.0F)); }

 private:
  static constexpr std::size_t kBins = 400;  // of 1 HU from -150
  std::vector<double> counts_ = std::vector<double>(kBins, 1e-3);
};

/// log of the ratio of two histograms' shares, as a table over intensity.
class IntensityRatio {
 public:
  IntensityRatio(const IntensityHistogram& in, const IntensityHistogram& out) {
    const std::vector<double> a = in.shares(), b = out.shares();
    for (std::size_t n = 0; n < a.size(); ++n)
      table_.push_back(static_cast<float>(std::log((a[n] + 1e-5) / (b[n] + 1e-5))));
  }
  float operator()(float intensity) const { return table_[IntensityHistogram::bin(intensity)]; }

 private:
  std::vector<float> table_;
};

}  // namespace glisson::segmentation
