// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/volume/plausibility.h"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <utility>

#include "glisson/core/error.h"

namespace glisson {
namespace {

constexpr double kLeastSide = 100.0, kMostWidth = 1000.0;  // mm
constexpr double kMostZerosCt = 0.4, kMostZeros = 0.95, kLeastTissue = 0.05, kLeastAir = 0.001;
constexpr int kIntercept = 1024;  // of most scanners, HU; the ranges below hold 1000 as well

/// Hounsfield units.
struct Range {
  int low, high;
};
constexpr Range kTissue{-150, 250}, kAir{-1100, -300};

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

struct Counts {
  long zeros = 0, constant = 0, repeated = 0;
};

Counts counted(const Image& image) {
  const std::vector<std::int16_t>& voxels = *image.voxels;
  const auto plane =
      static_cast<std::size_t>(image.grid.size.x()) * static_cast<std::size_t>(image.grid.size.y());
  Counts counts;
  counts.zeros = std::count(voxels.begin(), voxels.end(), std::int16_t{0});
  for (std::size_t begin = 0; begin + plane <= voxels.size(); begin += plane) {
    const auto first = voxels.begin() + static_cast<std::ptrdiff_t>(begin),
               last = first + static_cast<std::ptrdiff_t>(plane);
    const bool constant = std::all_of(first, last, [&](std::int16_t value) { return value == *first; });
    counts.constant += constant;
    counts.repeated +=
        !constant && begin > 0 && std::equal(first, last, first - static_cast<std::ptrdiff_t>(plane));
  }
  return counts;
}

/// How the voxels' values are spread.
class Values {
 public:
  explicit Values(const Image& image) : total_(static_cast<double>(image.voxels->size())) {
    for (const std::int16_t value : *image.voxels) ++counts_[static_cast<std::size_t>(value + kHalf)];
  }
  /// @param shift of the range.
  double share(const Range& range, int shift = 0) const {
    const auto at = [&](int value) {
      return counts_.begin() + std::clamp(value + shift + kHalf, 0, 2 * kHalf);
    };
    return static_cast<double>(std::accumulate(at(range.low), at(range.high + 1), 0L)) / total_;
  }
  bool holds_tissue(int shift = 0) const { return share(kTissue, shift) >= kLeastTissue; }
  bool holds_air(int shift = 0) const { return share(kAir, shift) >= kLeastAir; }

 private:
  static constexpr int kHalf = 32768;
  std::vector<long> counts_ = std::vector<long>(2 * kHalf, 0);
  double total_;
};

void require_voxels(const Image& image) {
  require(!image.empty() && static_cast<long>(image.voxels->size()) == image.grid.voxel_count(),
          "an image has one value a voxel");
}

}  // namespace

std::vector<std::string> scale_doubts(const Image& image) {
  require_voxels(image);
  std::vector<std::string> doubts;
  if (image.modality != Modality::ct) return doubts;
  const Values values(image);
  if (!values.holds_tissue()) doubts.push_back("image.no_tissue " + shown(100.0 * values.share(kTissue)));
  if (!values.holds_air()) doubts.push_back("image.no_air " + shown(100.0 * values.share(kAir)));
  if (doubts.empty()) return doubts;
  for (const int shift : {kIntercept, -kIntercept})
    if (values.holds_tissue(shift) && values.holds_air(shift))
      doubts.push_back("image.shifted " + std::to_string(-shift));
  return doubts;
}

std::vector<std::string> image_doubts(const Image& image) {
  require_voxels(image);
  std::vector<std::string> doubts;
  Eigen::Vector3d sides = image.grid.spacing_mm.cwiseProduct(image.grid.size.cast<double>());
  std::sort(sides.begin(), sides.end());
  if (sides[0] < kLeastSide) doubts.push_back("image.small " + shown(sides[0]));
  if (sides[1] > kMostWidth) doubts.push_back("image.large " + shown(sides[1]));
  const Counts counts = counted(image);
  const std::string planes = " " + std::to_string(image.grid.size.z());
  if (counts.constant > 0)
    doubts.push_back("image.constant_slices " + std::to_string(counts.constant) + planes);
  if (counts.repeated > 0)
    doubts.push_back("image.repeated_slices " + std::to_string(counts.repeated) + planes);
  const auto share = [&](long count) {
    return static_cast<double>(count) / static_cast<double>(image.voxels->size());
  };
  const bool ct = image.modality == Modality::ct;
  if (share(counts.zeros) > (ct ? kMostZerosCt : kMostZeros))
    doubts.push_back("image.zeros " + shown(100.0 * share(counts.zeros)));
  for (std::string& doubt : scale_doubts(image)) doubts.push_back(std::move(doubt));
  return doubts;
}

}  // namespace glisson
