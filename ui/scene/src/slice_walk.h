// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "glisson/ui/scene/slice_picture.h"

/// @file
/// How a slice runs through a volume's voxels.

namespace glisson::scene {

/// Walks a slice in voxel coordinates, which are affine in the pixel.
struct VoxelWalk {
  Eigen::Vector3d start, right, down;
  /// The voxel axes along which a row and a column of pixels run, and the one that stays; only where the
  /// slice lies along the volume's own axes (nearly always), which makes drawing several times as fast.
  bool aligned = false;
  int across = 0, along = 1, fixed = 2;

  VoxelWalk(const VolumeGrid& grid, const SliceGeometry& slice)
      : start(grid.index_of(slice.p_in_ct({0.0, 0.0}))),
        right(grid.index_of(slice.p_in_ct({1.0, 0.0})) - start),
        down(grid.index_of(slice.p_in_ct({0.0, 1.0})) - start) {
    right.cwiseAbs().maxCoeff(&across);
    down.cwiseAbs().maxCoeff(&along);
    fixed = 3 - across - along;
    // Whether the other axes stay within a thousandth of a voxel over the whole picture.
    const auto strays = [](Eigen::Vector3d step, int axis, int pixels) {
      step[axis] = 0.0;
      return pixels * step.cwiseAbs().maxCoeff() > 1e-3;
    };
    aligned = across != along && !strays(right, across, slice.width) && !strays(down, along, slice.height);
  }
  Eigen::Vector3d at(int u, int v) const { return start + u * right + v * down; }
};

/// Where a value is taken from along one axis: between two voxels.
struct Between {
  int low = 0, high = 0;
  double t = 0.0;
  bool inside = false;

  Between(double index, int size) {
    // Half a voxel beyond the outermost centres still belongs to the volume.
    inside = index >= -0.5 && index <= size - 0.5;
    double x = std::clamp(index, 0.0, size - 1.0);
    if (std::abs(x - std::round(x)) < 1e-6) x = std::round(x);  // takes rounding away
    low = static_cast<int>(x);
    high = std::min(low + 1, size - 1);
    t = x - low;
  }
};

struct Greys {
  double low, scale;
  explicit Greys(const SliceStyle& style)
      : low(style.level - 0.5 * style.width), scale(255.0 / style.width) {}
  std::uint8_t of(double value) const {
    return static_cast<std::uint8_t>(std::clamp((value - low) * scale + 1e-9, 0.0, 255.0));
  }
};

}  // namespace glisson::scene
