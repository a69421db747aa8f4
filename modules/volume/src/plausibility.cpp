// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/volume/plausibility.h"

#include <algorithm>
#include <cstdio>

#include "glisson/core/error.h"

namespace glisson {
namespace {

constexpr double kLeastSide = 100.0, kMostWidth = 1000.0;  // mm
constexpr double kMostZerosCt = 0.4, kMostZeros = 0.95, kLeastTissue = 0.05, kLeastAir = 0.001;

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

struct Counts {
  long zeros = 0, tissue = 0, air = 0, constant = 0, repeated = 0;
};

Counts counted(const Image& image) {
  const std::vector<std::int16_t>& voxels = *image.voxels;
  const auto plane =
      static_cast<std::size_t>(image.grid.size.x()) * static_cast<std::size_t>(image.grid.size.y());
  Counts counts;
  for (const std::int16_t value : voxels) {
    counts.zeros += value == 0;
    counts.tissue += value >= -150 && value <= 250;
    counts.air += value < -300;
  }
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

}  // namespace

std::vector<std::string> image_doubts(const Image& image) {
  require(!image.empty() && static_cast<long>(image.voxels->size()) == image.grid.voxel_count(),
          "an image has one value a voxel");
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
  if (ct && share(counts.tissue) < kLeastTissue)
    doubts.push_back("image.no_tissue " + shown(100.0 * share(counts.tissue)));
  if (ct && share(counts.air) < kLeastAir)
    doubts.push_back("image.no_air " + shown(100.0 * share(counts.air)));
  return doubts;
}

}  // namespace glisson
