// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "glisson/volume/dicom_segmentation.h"

namespace glisson {

std::optional<LabelVolume> placed_on(const LabelVolume& labels, const VolumeGrid& grid) {
  constexpr double kNear = 0.01;  // voxels, as VolumeGrid::same_as
  const VolumeGrid& own = labels.grid();
  const auto index = [&](const Eigen::Vector3i& v) {
    return Eigen::Vector3d(grid.index_of(own.p_in_ct(v.cast<double>())));
  };
  const Eigen::Vector3d first = index(Eigen::Vector3i::Zero());
  const Eigen::Vector3i start = first.array().round().matrix().cast<int>();
  if (!((first - start.cast<double>()).cwiseAbs().maxCoeff() <= kNear)) return std::nullopt;
  Eigen::Matrix3i steps = Eigen::Matrix3i::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    // Over the whole length, so that a small difference of spacing or direction shows.
    const int last = std::max(own.size[axis] - 1, 1);
    Eigen::Vector3i far = Eigen::Vector3i::Zero();
    far[axis] = last;
    const Eigen::Vector3d run = index(far) - first;
    const Eigen::Vector3i step = (run / last).array().round().matrix().cast<int>();
    if (step.cwiseAbs().sum() != 1 || !((run - (step * last).cast<double>()).cwiseAbs().maxCoeff() <= kNear))
      return std::nullopt;
    steps.col(axis) = step;
  }
  const Eigen::Vector3i end = start + steps * (own.size - Eigen::Vector3i::Ones());
  if (!grid.contains(start) || !grid.contains(end)) return std::nullopt;
  const std::vector<Label> from = labels.dense();
  std::vector<Label> to(static_cast<std::size_t>(grid.voxel_count()), 0);
  std::size_t at = 0;
  for (int k = 0; k < own.size.z(); ++k)
    for (int j = 0; j < own.size.y(); ++j)
      for (int i = 0; i < own.size.x(); ++i, ++at)
        to[static_cast<std::size_t>(grid.offset(start + steps * Eigen::Vector3i(i, j, k)))] = from[at];
  return LabelVolume(grid, to);
}

}  // namespace glisson
