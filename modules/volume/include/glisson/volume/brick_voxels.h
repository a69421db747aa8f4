// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/volume/label_volume.h"

namespace glisson {

/// The voxel at place `i` in the memory of a brick.
inline Eigen::Vector3i voxel_of(const LabelVolume& labels, std::size_t brick, std::size_t i) {
  constexpr int kSide = LabelVolume::kSide;
  const int n = static_cast<int>(i);
  return kSide * labels.brick_place(brick) +
         Eigen::Vector3i(n % kSide, n / kSide % kSide, n / (kSide * kSide));
}

/// Each voxel of a label, in the order of the bricks.
template <class Visit>
void each_voxel(const LabelVolume& labels, Label label, const Visit& visit) {
  for (std::size_t number = 0; number < labels.brick_count(); ++number) {
    const auto& brick = labels.brick(number);
    if (!brick) continue;
    for (std::size_t at = 0; at < brick->size(); ++at)
      if ((*brick)[at] == label) visit(voxel_of(labels, number, at));
  }
}

}  // namespace glisson
