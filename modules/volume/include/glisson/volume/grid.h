// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "glisson/core/frames.h"

namespace glisson {

/// Where the voxels of a volume lie in the patient. Lengths are millimetres here, as in the files (the names
/// say so); points are handed out in metres.
struct VolumeGrid {
  Eigen::Vector3i size = Eigen::Vector3i::Zero();  ///< voxels along i, j, k (i fastest in memory)
  Eigen::Vector3d spacing_mm = Eigen::Vector3d::Ones();
  Eigen::Vector3d origin_mm = Eigen::Vector3d::Zero();  ///< LPS, centre of voxel (0, 0, 0)
  /// Columns are the LPS directions of i, j, k; orthonormal, det +1 or -1.
  Eigen::Matrix3d direction = Eigen::Matrix3d::Identity();

  long voxel_count() const { return static_cast<long>(size.x()) * size.y() * size.z(); }
  long offset(const Eigen::Vector3i& v) const {
    return v.x() + static_cast<long>(size.x()) * (v.y() + static_cast<long>(size.y()) * v.z());
  }
  bool contains(const Eigen::Vector3i& v) const {
    return v[0] >= 0 && v[1] >= 0 && v[2] >= 0 && v[0] < size[0] && v[1] < size[1] && v[2] < size[2];
  }
  /// Centre of a (fractional) voxel index.
  Point<CtFrame> p_in_ct(const Eigen::Vector3d& index) const;
  /// The inverse: metres in, a fractional index out, which may lie outside the volume.
  Eigen::Vector3d index_of(const Point<CtFrame>& p) const;
  /// Product of the spacings.
  double voxel_volume_mm3() const;
  /// Same size, and same place to within a hundredth of a voxel.
  bool same_as(const VolumeGrid& other) const;
};

}  // namespace glisson
