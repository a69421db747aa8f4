// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "glisson/volume/grid.h"

/// @file
/// Exact distances and the morphology built on them, on dense 0/1 masks whose voxels need not be cubes.

namespace glisson {

/// A dense 0/1 volume, i fastest. The frame plays no part here: only how large a voxel is.
struct Mask {
  Eigen::Vector3i size = Eigen::Vector3i::Zero();
  Eigen::Vector3d spacing_mm = Eigen::Vector3d::Ones();
  std::vector<std::uint8_t> voxels;

  Mask() = default;
  /// All zero.
  Mask(const Eigen::Vector3i& extent, const Eigen::Vector3d& spacing)
      : size(extent),
        spacing_mm(spacing),
        voxels(static_cast<std::size_t>(extent.x()) * static_cast<std::size_t>(extent.y()) *
               static_cast<std::size_t>(extent.z())) {}
  std::size_t offset(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(size.x()) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(k));
  }
  /// Voxels that are set; any value but 0 is.
  long count() const;
};

/// Voxels low..high-1 of a volume.
struct VoxelBox {
  Eigen::Vector3i low = Eigen::Vector3i::Zero();
  Eigen::Vector3i high = Eigen::Vector3i::Zero();
  bool empty() const { return (low.array() >= high.array()).any(); }
  Eigen::Vector3i size() const { return high - low; }
};
/// The smallest box around the voxels that are set, grown by margin_mm and kept inside. Empty when none is.
VoxelBox bounding_box(const Eigen::Vector3i& size, const Eigen::Vector3d& spacing_mm,
                      const std::vector<std::uint8_t>& voxels, double margin_mm);
/// @pre voxels has size.prod() values and the box lies inside.
Mask crop(const Eigen::Vector3i& size, const Eigen::Vector3d& spacing_mm,
          const std::vector<std::uint8_t>& voxels, const VoxelBox& box);
/// Writes a crop back into the volume that it came from.
void paste(const Mask& part, const VoxelBox& box, const Eigen::Vector3i& size,
           std::vector<std::uint8_t>& voxels);

/// Square of the exact Euclidean distance in mm from each voxel's centre to the nearest set voxel's centre
/// (Felzenszwalb and Huttenlocher 2012, one pass an axis). Infinite when no voxel is set.
std::vector<float> squared_distance_mm2(const Mask& mask);
/// The same to the nearest voxel that is not set: how deep each one lies in the mask.
std::vector<float> squared_depth_mm2(const Mask& mask);

/// Set where `mask` is not.
Mask complement(Mask mask);

/// Morphology with a ball of `radius_mm`. Outside the volume counts as background for dilation and as
/// foreground for erosion, so that an organ cut by the image's edge is not eaten from there. For closing it
/// is background throughout: what is closed does not depend on where the volume ends.
Mask dilated(const Mask& mask, double radius_mm);
Mask eroded(const Mask& mask, double radius_mm);
Mask opened(const Mask& mask, double radius_mm);
Mask closed(const Mask& mask, double radius_mm);

/// Components joined through faces. Returns for each voxel 0 (background) or the number of its component,
/// 1 the largest, falling by size; sizes[n - 1] is the size of n.
std::vector<int> connected_components(const Mask& mask, std::vector<long>& sizes);
/// The largest component (through faces).
Mask largest_component(const Mask& mask);
/// Sets the background that cannot be reached from the volume's edge through faces.
Mask holes_filled(const Mask& mask);
/// Sets the background that is enclosed within a slice, for the slices along each of the three axes.
Mask slice_holes_filled(const Mask& mask);

}  // namespace glisson
