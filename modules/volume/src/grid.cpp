// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/volume/grid.h"

#include "glisson/volume/axes.h"

namespace glisson {

// Not in the header: some seven hundred units read it, and each would instantiate these expressions again.
Point<CtFrame> VolumeGrid::p_in_ct(const Eigen::Vector3d& index) const {
  return Point<CtFrame>(1e-3 * (origin_mm + direction * index.cwiseProduct(spacing_mm)));
}

Eigen::Vector3d VolumeGrid::index_of(const Point<CtFrame>& p) const {
  return (direction.inverse() * (1e3 * p.xyz - origin_mm)).cwiseQuotient(spacing_mm);
}

double VolumeGrid::voxel_volume_mm3() const { return spacing_mm.prod(); }

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

int axis_along(const VolumeGrid& grid, int of_patient) {
  Eigen::Index axis = 0;
  grid.direction.row(of_patient).cwiseAbs().maxCoeff(&axis);
  return static_cast<int>(axis);
}

}  // namespace glisson
