// SPDX-License-Identifier: GPL-3.0-or-later
#include "painting.h"

#include <algorithm>
#include <cmath>

#include "level_set.h"

namespace glisson::segmentation {
namespace {

/// @param inside of a place in the image's voxel coordinates.
template <class Inside>
Mask mask_of(const Field& grid, const Inside& inside) {
  Mask mask = grid.empty_mask();
  std::size_t at = 0;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i, ++at)
        mask.voxels[at] =
            inside(Eigen::Vector3d(grid.first_index + Eigen::Vector3d(i, j, k).cwiseProduct(grid.step))) ? 1
                                                                                                         : 0;
  return mask;
}

}  // namespace

Mask negative_of(const Field& phi) {
  Mask mask = phi.empty_mask();
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) mask.voxels[i] = phi.values[i] < 0.0F ? 1 : 0;
  return mask;
}

Field smooth_boundary(const Mask& mask, const Field& grid) {
  Field phi = signed_distance(mask, grid);
  smooth(phi, 0.5 * grid.spacing_mm.minCoeff());
  return phi;
}

VoxelBox image_box(const VolumeGrid& image, const Field& grid, const Mask& mask, double margin_mm) {
  const VoxelBox inner = bounding_box(mask.size, mask.spacing_mm, mask.voxels, margin_mm);
  VoxelBox box;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = grid.first_index[axis] + grid.step[axis] * (inner.low[axis] - 1);
    const double high = grid.first_index[axis] + grid.step[axis] * inner.high[axis];
    box.low[axis] = std::clamp(static_cast<int>(std::floor(low)), 0, image.size[axis] - 1);
    box.high[axis] = std::clamp(static_cast<int>(std::ceil(high)) + 1, box.low[axis] + 1, image.size[axis]);
  }
  return box;
}

Mask transferred(const Field& phi, const Field& to) {
  return mask_of(to, [&](const Eigen::Vector3d& index) {
    const Eigen::Vector3i v = phi.voxel_of(index).cwiseMax(0).cwiseMin(phi.size - Eigen::Vector3i::Ones());
    return phi.values[phi.offset(v)] < 0.0F;
  });
}

Mask covered(const Field& phi, const Field& to) {
  return mask_of(to, [&](const Eigen::Vector3d& index) {
    const Eigen::Vector3i v = phi.voxel_of(index);
    return phi.contains(v) && phi.values[phi.offset(v)] < 0.0F;
  });
}

Mask sampled(const VolumeGrid& image, const std::vector<std::uint8_t>& voxels, const Field& to) {
  return mask_of(to, [&](const Eigen::Vector3d& index) {
    const Eigen::Vector3i v =
        index.array().round().matrix().cast<int>().cwiseMax(0).cwiseMin(image.size - Eigen::Vector3i::Ones());
    return voxels[static_cast<std::size_t>(image.offset(v))] != 0;
  });
}

Field interpolated(const Field& from, const Field& to) {
  // The target's voxels as the "image" that the source is interpolated on.
  Field source = from;
  source.first_index = (from.first_index - to.first_index).cwiseQuotient(to.step);
  source.step = from.step.cwiseQuotient(to.step);
  Field result = to;
  result.values = on_image(source, {Eigen::Vector3i::Zero(), to.size});
  return result;
}

void Painting::paint(const Field& phi, const VoxelBox& box, Label label) {
  const std::vector<float> values = on_image(phi, box);
  std::size_t at = 0;
  for (int k = box.low.z(); k < box.high.z(); ++k)
    for (int j = box.low.y(); j < box.high.y(); ++j)
      for (int i = box.low.x(); i < box.high.x(); ++i, ++at) {
        const auto place = static_cast<std::size_t>(grid.offset({i, j, k}));
        if (values[at] < 0.0F && held[place] == 0) labels[place] = label;
      }
}

}  // namespace glisson::segmentation
