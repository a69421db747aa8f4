// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace glisson {

/// Calls visit(neighbour, axis) for each voxel inside the volume that shares a face with the one at `at`:
/// along i, j and k in turn, the lower one first. Places are those in memory, i fastest.
template <class Visit>
void each_face_neighbour(const Eigen::Vector3i& size, std::size_t at, const Visit& visit) {
  const auto nx = static_cast<std::size_t>(size.x()), ny = static_cast<std::size_t>(size.y()),
             nz = static_cast<std::size_t>(size.z());
  const std::size_t slice = nx * ny;
  const std::size_t i = at % nx, j = at / nx % ny, k = at / slice;
  if (i > 0) visit(at - 1, 0);
  if (i + 1 < nx) visit(at + 1, 0);
  if (j > 0) visit(at - nx, 1);
  if (j + 1 < ny) visit(at + nx, 1);
  if (k > 0) visit(at - slice, 2);
  if (k + 1 < nz) visit(at + slice, 2);
}

}  // namespace glisson
