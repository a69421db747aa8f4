// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/volume/grid.h"

namespace glisson {

bool VolumeGrid::same_as(const VolumeGrid& other) const {
  if (size != other.size) return false;
  // The two far corners decide: a difference in origin, spacing or direction shows in one of them.
  const Eigen::Vector3d far = (size - Eigen::Vector3i::Ones()).cast<double>();
  const double tolerance = 1e-5 * spacing_mm.minCoeff();  // metres: a hundredth of a voxel
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d index =
        far.cwiseProduct(Eigen::Vector3d(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1));
    if ((p_in_ct(index).xyz - other.p_in_ct(index).xyz).norm() > tolerance) return false;
  }
  return true;
}

}  // namespace glisson
