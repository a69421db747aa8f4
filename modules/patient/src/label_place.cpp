// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/label_place.h"

#include <limits>

#include "glisson/volume/brick_voxels.h"

namespace glisson {
std::optional<Point<CtFrame>> place_of(const LabelVolume& labels, Label label) {
  const VolumeGrid& grid = labels.grid();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  long count = 0;
  each_voxel(labels, label, [&](const Eigen::Vector3i& v) { sum += v.cast<double>(), ++count; });
  if (label == 0 || count == 0) return {};
  const Eigen::Vector3d middle = sum / static_cast<double>(count);
  Eigen::Vector3i nearest = Eigen::Vector3i::Zero();
  double least = std::numeric_limits<double>::infinity();
  each_voxel(labels, label, [&](const Eigen::Vector3i& v) {
    const double off = (v.cast<double>() - middle).cwiseProduct(grid.spacing_mm).squaredNorm();
    if (off < least) least = off, nearest = v;
  });
  return grid.p_in_ct(nearest.cast<double>());
}

}  // namespace glisson
