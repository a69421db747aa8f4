// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/volume/image.h"
#include "glisson/volume/morphology.h"

namespace glisson::segmentation {

/// A real-valued volume on a grid of its own, along the axes of the image that it was made from.
struct Field {
  Eigen::Vector3i size = Eigen::Vector3i::Zero();
  Eigen::Vector3d spacing_mm = Eigen::Vector3d::Ones();
  /// Index in the image of voxel (0, 0, 0)'s centre, and image voxels per voxel.
  Eigen::Vector3d first_index = Eigen::Vector3d::Zero();
  Eigen::Vector3d step = Eigen::Vector3d::Ones();
  std::vector<float> values;

  std::size_t offset(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(size.x()) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(k));
  }
  std::size_t offset(const Eigen::Vector3i& v) const { return offset(v.x(), v.y(), v.z()); }
  Eigen::Vector3i voxel_at(std::size_t offset) const {
    const auto nx = static_cast<std::size_t>(size.x()), ny = static_cast<std::size_t>(size.y());
    return {static_cast<int>(offset % nx), static_cast<int>(offset / nx % ny),
            static_cast<int>(offset / (nx * ny))};
  }
  bool contains(const Eigen::Vector3i& v) const {
    return (v.array() >= 0).all() && (v.array() < size.array()).all();
  }
  /// The voxel nearest to an index of the image; may lie outside.
  Eigen::Vector3i voxel_of(const Eigen::Vector3d& image_index) const {
    return (image_index - first_index).cwiseQuotient(step).array().round().matrix().cast<int>();
  }
  Mask empty_mask() const { return Mask(size, spacing_mm); }
  /// The part of it in a box of its voxels; the image's indices stay right.
  Field cropped(const VoxelBox& box) const;
  /// The same grid, all `value`.
  Field filled(float value) const;
};

/// The part `box` of an image at about `spacing_mm` (never finer than that; coarser voxels of the image are
/// interpolated). Each axis is filtered by a triangle as wide as the coarser of the two spacings.
Field resampled(const Image& image, const VoxelBox& box, double spacing_mm);

/// Value at each voxel of `box` of the image, trilinear, constant beyond the field's edge.
std::vector<float> on_image(const Field& field, const VoxelBox& box);

/// Edge-preserving smoothing (Perona and Malik 1990): differences well above `contrast` stay.
void diffuse(Field& field, double contrast, int iterations);
/// The same for a CT: ten steps, 15 HU. Noise is below, edges are above.
void denoise(Field& ct);

/// Gaussian smoothing, one axis after the other, edges replicated.
void smooth(Field& field, double sigma_mm);

/// |gradient| per mm, central differences.
std::vector<float> gradient_magnitude(const Field& field);

}  // namespace glisson::segmentation
