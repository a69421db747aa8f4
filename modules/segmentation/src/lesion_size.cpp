// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/lesion_size.h"

#include <algorithm>
#include <cmath>

namespace glisson::segmentation {
namespace {

struct Place {
  Eigen::Vector3i index;
  Eigen::Vector3d mm;
  double from_middle = 0.0;
};

/// The first and the last set voxel of every row along i: the farthest pair is among them, for between two
/// voxels of a row one end is always at least as far from any third.
std::vector<Place> row_ends(const Mask& mask) {
  std::vector<Place> ends;
  for (int k = 0; k < mask.size.z(); ++k)
    for (int j = 0; j < mask.size.y(); ++j) {
      int first = -1, last = -1;
      for (int i = 0; i < mask.size.x(); ++i) {
        if (mask.voxels[mask.offset(i, j, k)] == 0) continue;
        if (first < 0) first = i;
        last = i;
      }
      for (const int i : {first, last}) {
        if (i < 0 ||
            (i == first && i == last && !ends.empty() && ends.back().index == Eigen::Vector3i(i, j, k)))
          continue;
        const Eigen::Vector3i index(i, j, k);
        ends.push_back({index, index.cast<double>().cwiseProduct(mask.spacing_mm)});
      }
    }
  return ends;
}

}  // namespace

LongestDiameter longest_diameter(const Mask& mask) {
  std::vector<Place> ends = row_ends(mask);
  LongestDiameter best;
  if (ends.empty()) return best;
  Eigen::Vector3d middle(0, 0, 0);
  for (const Place& place : ends) middle += place.mm / static_cast<double>(ends.size());
  for (Place& place : ends) place.from_middle = (place.mm - middle).norm();
  std::stable_sort(ends.begin(), ends.end(),
                   [](const Place& a, const Place& b) { return a.from_middle > b.from_middle; });
  const Place *from = &ends.front(), *to = from;
  double longest2 = 0.0;
  const auto consider = [&](const Place& a, const Place& b) {
    const double d2 = (a.mm - b.mm).squaredNorm();
    if (d2 > longest2) longest2 = d2, from = &a, to = &b;
  };
  // There and back from the outermost: nearly the longest at once, and the bounds below bite.
  for (int round = 0; round < 3; ++round) {
    const Place& start = *to;
    for (const Place& place : ends) consider(start, place);
  }
  for (std::size_t a = 0; a < ends.size(); ++a) {
    const double longest = std::sqrt(longest2);
    if (2.0 * ends[a].from_middle <= longest) break;
    for (std::size_t b = a + 1; b < ends.size(); ++b) {
      // Never farther apart than by way of the middle.
      if (ends[a].from_middle + ends[b].from_middle <= longest) break;
      consider(ends[a], ends[b]);
    }
  }
  best.mm = std::sqrt(longest2);
  best.from = from->index;
  best.to = to->index;
  const auto in_memory = [&](const Eigen::Vector3i& v) { return mask.offset(v.x(), v.y(), v.z()); };
  if (in_memory(best.from) > in_memory(best.to)) std::swap(best.from, best.to);
  return best;
}

double longest_diameter_mm(const Mask& mask) { return longest_diameter(mask).mm; }

LongestDiameter longest_diameter(const LabelVolume& labels, Label label) {
  constexpr int kSide = LabelVolume::kSide;
  // Only the bricks that hold it are looked at.
  std::vector<std::size_t> bricks;
  VoxelBox box{labels.grid().size, Eigen::Vector3i::Zero()};
  for (std::size_t n = 0; n < labels.brick_count(); ++n) {
    const auto& brick = labels.brick(n);
    if (!brick || std::find(brick->begin(), brick->end(), label) == brick->end()) continue;
    bricks.push_back(n);
    const Eigen::Vector3i low = kSide * labels.brick_place(n);
    box.low = box.low.cwiseMin(low);
    box.high = box.high.cwiseMax((low.array() + kSide).matrix());
  }
  if (bricks.empty()) return {};
  Mask mask(box.size(), labels.grid().spacing_mm);
  for (const std::size_t n : bricks) {
    const Eigen::Vector3i low = kSide * labels.brick_place(n) - box.low;
    std::size_t at = 0;
    for (int k = 0; k < kSide; ++k)
      for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i, ++at)
          if ((*labels.brick(n))[at] == label)
            mask.voxels[mask.offset(low.x() + i, low.y() + j, low.z() + k)] = 1;
  }
  LongestDiameter diameter = longest_diameter(mask);
  diameter.from += box.low;
  diameter.to += box.low;
  return diameter;
}

}  // namespace glisson::segmentation
