// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "glisson/volume/image.h"

namespace glisson::test {

/// @param sigma of the noise, HU. @param hounsfield of a place in mm from the first voxel's centre; it is
/// asked once for each voxel, i fastest.
template <class Hounsfield>
Image noisy_ct(const VolumeGrid& grid, unsigned seed, double sigma, const Hounsfield& hounsfield) {
  Image image;
  image.grid = grid;
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, sigma);
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const double hu = hounsfield(Eigen::Vector3d(Eigen::Vector3d(i, j, k).cwiseProduct(grid.spacing_mm)));
        voxels.push_back(static_cast<std::int16_t>(std::lround(hu + noise(random))));
      }
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
  return image;
}

}  // namespace glisson::test
