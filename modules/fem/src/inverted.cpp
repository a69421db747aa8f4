// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/fem/inverted.h"

#include <Eigen/Geometry>

namespace glisson::fem {

int inverted_tetrahedra(const CompositeModel& model, const Points& x) {
  const auto& tetrahedra = model.mesh().tetrahedra;
  int count = 0;
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t) {
    const Eigen::Vector3d a = x.row(tetrahedra(t, 0)).transpose();
    const Eigen::Vector3d b = x.row(tetrahedra(t, 1)).transpose() - a,
                          c = x.row(tetrahedra(t, 2)).transpose() - a,
                          d = x.row(tetrahedra(t, 3)).transpose() - a;
    count += b.cross(c).dot(d) <= 0.0;
  }
  return count;
}

}  // namespace glisson::fem
