// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>

#include "glisson/geometry/mesh.h"
#include "glisson/volume/image.h"

namespace glisson::test {

/// @param places_mm from the corner of the image. @return metres, CT frame.
inline Points points_at(const Image& image, std::initializer_list<Eigen::Vector3d> places_mm) {
  Points points(static_cast<Eigen::Index>(places_mm.size()), 3);
  Eigen::Index n = 0;
  for (const Eigen::Vector3d& place : places_mm)
    points.row(n++) = (1e-3 * (image.grid.origin_mm + place)).transpose();
  return points;
}

}  // namespace glisson::test
