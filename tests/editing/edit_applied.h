// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_naive.h"

namespace glisson::test {

inline Points one_point(const Eigen::Vector3d& p) {
  Points path(1, 3);
  path.row(0) = p.transpose();
  return path;
}

/// Fine cubes in a box of 40 mm, so that volumes are those of the shapes.
inline VolumeGrid fine_grid(double spacing_mm = 0.5) {
  VolumeGrid grid;
  grid.size = Eigen::Vector3i::Constant(static_cast<int>(40.0 / spacing_mm));
  grid.spacing_mm.setConstant(spacing_mm);
  return grid;
}

inline double ml_of(const LabelMap& labels, Label label) {
  const std::vector<long> counts = labels.voxels.histogram();
  return label < counts.size() ? 1e-3 * counts[label] * labels.voxels.grid().voxel_volume_mm3() : 0.0;
}

inline Edited applied(const LabelMap& labels, const Image& image, const Tool& tool,
                      const EditableRegion& region = {}) {
  return apply_edit(labels, image, {tool, region}, RunContext()).value();
}

inline Image noisy(const VolumeGrid& grid, unsigned seed) {
  std::mt19937 random(seed);
  return image_of(grid, [&](const Eigen::Vector3i&) { return static_cast<double>(random() % 200) - 100.0; });
}

}  // namespace glisson::test
