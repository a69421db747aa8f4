// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "glisson/patient/label_map.h"
#include "glisson/volume/image.h"

namespace glisson::bench {

/// A CT and its labels; lengths are millimetres from the volume's middle.
struct Scene {
  Image image;
  LabelMap labels;
  Eigen::Vector3d p_at(const Eigen::Vector3d& place_mm) const {
    const Eigen::Vector3d middle = 0.5 * (image.grid.size - Eigen::Vector3i::Ones()).cast<double>();
    return image.grid.p_in_ct(middle + place_mm.cwiseQuotient(image.grid.spacing_mm)).xyz;
  }
};

inline Label label_at(const Eigen::Vector3d& p) {
  if (p.cwiseQuotient(Eigen::Vector3d(95, 70, 54)).squaredNorm() > 1.0) return structure::kBackground;
  if ((p - Eigen::Vector3d(40, 10, 5)).norm() < 15.0) return structure::kFirstLesion;
  // Combs of tubes that grow thinner, one for each tree.
  const double portal = std::hypot(p.y() - 8.0, p.z() + 4.0),
               hepatic = std::hypot(p.y() + 20.0, p.z() - 10.0);
  const double along = p.x() - 20.0 * std::round(p.x() / 20.0);
  if (portal < 6.0 - 0.03 * std::abs(p.x()) || (std::hypot(along, p.z() + 4.0) < 2.5 && p.y() > 8.0))
    return structure::kPortalVein;
  if (hepatic < 5.0 - 0.03 * std::abs(p.x()) ||
      (std::hypot(along - 6.0, p.z() - 10.0) < 2.2 && p.y() < -20.0))
    return structure::kHepaticVeins;
  return structure::kParenchyma;
}

inline double intensity_of(Label label) {
  switch (label) {
    case structure::kBackground:
      return -60.0;
    case structure::kParenchyma:
      return 110.0;
    case structure::kFirstLesion:
      return 65.0;
    default:
      return 170.0;
  }
}

inline const Scene& scene() {
  static const Scene made = [] {
    Scene s;
    VolumeGrid& grid = s.image.grid;
    grid.size = {512, 512, 500};
    grid.spacing_mm.setConstant(0.7);
    std::vector<std::int16_t> voxels;
    voxels.reserve(static_cast<std::size_t>(grid.voxel_count()));
    std::vector<Label> dense;
    dense.reserve(voxels.capacity());
    std::uint32_t noise = 1;
    const Eigen::Vector3d middle = 0.5 * (grid.size - Eigen::Vector3i::Ones()).cast<double>();
    for (int k = 0; k < grid.size.z(); ++k)
      for (int j = 0; j < grid.size.y(); ++j)
        for (int i = 0; i < grid.size.x(); ++i) {
          noise = noise * 1664525U + 1013904223U;
          const Label label = label_at((Eigen::Vector3d(i, j, k) - middle) * 0.7);
          dense.push_back(label);
          // Uniform, of 15 HU standard deviation.
          voxels.push_back(static_cast<std::int16_t>(intensity_of(label) + (noise >> 16) % 53 - 26.0));
        }
    s.image.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
    s.labels.voxels = LabelVolume(grid, dense);
    return s;
  }();
  return made;
}

}  // namespace glisson::bench
