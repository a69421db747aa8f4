// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/volume/image.h"

namespace glisson::test {

/// A ball of liver's tissue on the right, in fat.
inline Image ball_ct(double radius_mm) {
  Image image;
  image.grid.size = {80, 60, 40};
  image.grid.spacing_mm = {4.0, 4.0, 4.0};
  image.grid.origin_mm = {-160.0, -120.0, -80.0};
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 80; ++i) {
        const Eigen::Vector3d mm = 1e3 * image.grid.p_in_ct(Eigen::Vector3d(i, j, k)).xyz;
        voxels.push_back((mm - Eigen::Vector3d(-80.0, 0.0, 0.0)).norm() < radius_mm ? 110 : -100);
      }
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
  return image;
}

}  // namespace glisson::test
