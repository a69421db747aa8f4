// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field.h"

namespace glisson::test {

/// Cubic voxels, the first one's centre at the origin.
inline segmentation::Field field_of(const Eigen::Vector3i& size, double spacing_mm) {
  segmentation::Field field;
  field.size = size;
  field.spacing_mm = Eigen::Vector3d::Constant(spacing_mm);
  field.step = field.spacing_mm;
  return field.filled(0.0F);
}

/// Calls visit(place in memory, place in mm) for each voxel.
template <class Visit>
void each_voxel(const segmentation::Field& field, const Visit& visit) {
  for (int k = 0; k < field.size.z(); ++k)
    for (int j = 0; j < field.size.y(); ++j)
      for (int i = 0; i < field.size.x(); ++i)
        visit(field.offset(i, j, k),
              Eigen::Vector3d(Eigen::Vector3d(i, j, k).cwiseProduct(field.spacing_mm)));
}

template <class Value>
void fill(segmentation::Field& field, const Value& value) {
  each_voxel(field, [&](std::size_t at, const Eigen::Vector3d& p) {
    field.values[at] = static_cast<float>(value(p));
  });
}

template <class Inside>
Mask body(const segmentation::Field& field, const Inside& inside) {
  Mask mask = field.empty_mask();
  each_voxel(field, [&](std::size_t at, const Eigen::Vector3d& p) { mask.voxels[at] = inside(p) ? 1 : 0; });
  return mask;
}

}  // namespace glisson::test
