// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "glisson/volume/dicom_segmentation.h"

namespace glisson {

namespace {

constexpr double kNear = 0.01;  // voxels, as VolumeGrid::same_as
/// Slices. The CT's reader takes slices that lie up to half a gap from their places in its even grid, as
/// rounded positions do. A quarter from one slice is three quarters from the next: it is clear which is
/// meant.
constexpr double kNearSlice = 0.25;
constexpr int kSlices = 2;  // the axis from slice to slice

/// Whether places differ by no more than is allowed. @param off voxels.
bool is_near(const Eigen::Vector3d& off, double along_slices) {
  const Eigen::Array3d allowed(kNear, kNear, along_slices);
  return (off.array().abs() <= allowed).all();
}

}  // namespace

std::optional<LabelVolume> placed_on(const LabelVolume& labels, const VolumeGrid& grid) {
  const VolumeGrid& own = labels.grid();
  const auto index = [&](const Eigen::Vector3i& v) {
    return Eigen::Vector3d(grid.index_of(own.p_in_ct(v.cast<double>())));
  };
  const Eigen::Vector3d first = index(Eigen::Vector3i::Zero());
  const Eigen::Vector3i start = first.array().round().matrix().cast<int>();
  Eigen::Matrix3d off = Eigen::Matrix3d::Zero();  // of each axis' last voxel from its place, less the first's
  Eigen::Matrix3i steps = Eigen::Matrix3i::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    // Over the whole length, so that a small difference of spacing or direction shows.
    const int last = std::max(own.size[axis] - 1, 1);
    Eigen::Vector3i far = Eigen::Vector3i::Zero();
    far[axis] = last;
    Eigen::Vector3d run = index(far) - first;
    // From a single slice to the next there is no gap: its grid holds its thickness, and slices may overlap.
    if (axis == kSlices && own.size[axis] == 1) run.normalize();
    steps.col(axis) = (run / last).array().round().matrix().cast<int>();
    if (steps.col(axis).cwiseAbs().sum() != 1) return std::nullopt;
    off.col(axis) = run - (steps.col(axis) * last).cast<double>();
  }
  const double along = steps.col(kSlices).cwiseAbs()[kSlices] == 1 ? kNearSlice : kNear;
  const Eigen::Vector3d off_first = first - start.cast<double>();
  const Eigen::Vector3d off_last = off_first + off.col(kSlices);
  if (!is_near(off_first, along) || !is_near(off.col(0), kNear) || !is_near(off.col(1), kNear) ||
      !is_near(off_last, along))
    return std::nullopt;
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
