// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field.h"
#include "glisson/patient/label_map.h"

namespace glisson::segmentation {

/// Where a field is negative.
Mask negative_of(const Field& phi);

/// A mask of a field's grid as a smooth function, negative inside, at about half a voxel.
Field smooth_boundary(const Mask& mask, const Field& grid);

/// The image's voxels that the set voxels of `mask` cover, and a margin.
VoxelBox image_box(const VolumeGrid& image, const Field& grid, const Mask& mask, double margin_mm);

/// The same, nothing beyond the field's own voxels.
Mask covered(const Field& phi, const Field& to);
/// Where `phi` is negative, on the grid of another field of the same image: the nearest voxel counts.
Mask transferred(const Field& phi, const Field& to);
/// A dense 0/1 mask of the image on a field's grid: the nearest voxel counts.
Mask sampled(const VolumeGrid& image, const std::vector<std::uint8_t>& voxels, const Field& to);
/// Values of a field on another field's grid, trilinear, constant beyond its edge.
Field interpolated(const Field& from, const Field& to);

/// Labels of a whole (cropped) image being painted.
struct Painting {
  VolumeGrid grid;
  std::vector<Label> labels;
  std::vector<std::uint8_t> held;  ///< voxels that nothing is painted on
  /// Where `phi` is negative within `box`.
  void paint(const Field& phi, const VoxelBox& box, Label label);
};

}  // namespace glisson::segmentation
