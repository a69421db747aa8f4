// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "glisson/volume/image.h"

namespace glisson::test {

/// A small world in LPS without any symmetry: every voxel of a 6 x 5 x 4 block has a value of its own.
inline const Eigen::Vector3i kWorldSize(6, 5, 4);
inline const Eigen::Vector3d kWorldSpacing(0.8, 1.1, 2.5);
inline const Eigen::Vector3d kWorldOrigin(-31.0, 17.0, 402.5);
inline std::int16_t world_value(const Eigen::Vector3i& v) {
  return static_cast<std::int16_t>(-1000 + 100 * v.x() + 10 * v.y() + v.z());
}

/// One of the 48 ways to store the world: which axis comes when, and which of them run backwards.
inline Image stored_world(int orientation) {
  static constexpr int kOrder[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  const int* order = kOrder[orientation / 8];
  Image image;
  image.grid.direction.setZero();
  Eigen::Vector3d first = kWorldOrigin;
  for (int axis = 0; axis < 3; ++axis) {
    const int world = order[axis];
    const bool backwards = ((orientation >> axis) & 1) != 0;
    image.grid.size[axis] = kWorldSize[world];
    image.grid.spacing_mm[axis] = kWorldSpacing[world];
    image.grid.direction(world, axis) = backwards ? -1.0 : 1.0;
    if (backwards) first[world] += kWorldSpacing[world] * (kWorldSize[world] - 1);
  }
  image.grid.origin_mm = first;
  std::vector<std::int16_t> values;
  for (int k = 0; k < image.grid.size.z(); ++k)
    for (int j = 0; j < image.grid.size.y(); ++j)
      for (int i = 0; i < image.grid.size.x(); ++i) {
        const Eigen::Vector3d p = 1e3 * image.grid.p_in_ct(Eigen::Vector3d(i, j, k)).xyz;
        const Eigen::Vector3d w = (p - kWorldOrigin).cwiseQuotient(kWorldSpacing);
        values.push_back(world_value(w.array().round().matrix().cast<int>()));
      }
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(values));
  return image;
}

/// Whether each point of the world has its value in `image`, wherever that voxel is stored.
inline bool shows_world(const Image& image) {
  if (image.grid.voxel_count() != kWorldSize.prod()) return false;
  for (int k = 0; k < kWorldSize.z(); ++k)
    for (int j = 0; j < kWorldSize.y(); ++j)
      for (int i = 0; i < kWorldSize.x(); ++i) {
        const Eigen::Vector3d p = kWorldOrigin + Eigen::Vector3d(i, j, k).cwiseProduct(kWorldSpacing);
        const Eigen::Vector3d index = image.grid.index_of(Point<CtFrame>(1e-3 * p));
        const Eigen::Vector3i voxel = index.array().round().matrix().cast<int>();
        if ((index - voxel.cast<double>()).norm() > 1e-3 || !image.grid.contains(voxel)) return false;
        if (image.at(voxel) != world_value({i, j, k})) return false;
      }
  return true;
}

}  // namespace glisson::test
