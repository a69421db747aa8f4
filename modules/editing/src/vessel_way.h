// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/volume/image.h"
#include "glisson/volume/morphology.h"

/// @file
/// The way of a vessel through an image. Places are millimetres along the voxel axes (index times spacing):
/// how the volume lies in the patient plays no part, as its axes are at right angles.

namespace glisson::editing {

/// A box of an image as fractions.
struct Part {
  VoxelBox box;
  Eigen::Vector3i size = Eigen::Vector3i::Zero();
  Eigen::Vector3d spacing_mm = Eigen::Vector3d::Ones();
  std::vector<float> values;  ///< i fastest

  std::size_t offset(const Eigen::Vector3i& inside) const {
    return static_cast<std::size_t>(inside.x()) +
           static_cast<std::size_t>(size.x()) *
               (static_cast<std::size_t>(inside.y()) +
                static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(inside.z()));
  }
  /// Trilinear; outside, the nearest place of the box. @param place mm in the whole volume.
  double at(const Eigen::Vector3d& place) const;
};
/// Smoothed by a Gaussian of so many mm along each axis (less than a third of a voxel: not at all).
Part smoothed_part(const Image& image, const VoxelBox& box, double sigma_mm);

/// How a vessel looks beside what is about it.
struct Looks {
  double sign = 1.0;             ///< -1: darker than what is about it
  double low = 0.0, high = 0.0;  ///< of the vessel, times the sign
  double contrast = 1.0;         ///< above 0
  bool seen = false;             ///< the contrast is more than noise
};

/// Whether a value is soft tissue that a vessel may run through.
bool is_tissue(const Image& image, double value);

/// The cheapest way between two places.
/// @param open whether the way may run through a voxel, by its index.
/// @returns voxels of the whole volume from first to last, neighbours by faces, edges or corners; empty:
/// there
///   is no way. No value: cancelled.
Cancellable<std::vector<Eigen::Vector3i>> cheapest_way(
    const Image& image, const VoxelBox& box, const Eigen::Vector3i& from, const Eigen::Vector3i& to,
    const Looks& looks, const std::function<bool(const Eigen::Vector3i&)>& open, const RunContext& context);

/// What the places of two clicks show. @param part lightly smoothed, around both.
Looks looks_at(const Image& image, const Part& part, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace glisson::editing
