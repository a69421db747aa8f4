// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vessel_way.h"

namespace glisson::editing {

/// A vessel as balls along a line. Places are millimetres along the voxel axes.
struct Tube {
  std::vector<Eigen::Vector3d> places;  ///< half a millimetre apart at the most
  std::vector<double> radii_mm;
  double seen = 0.0;  ///< the part of the places at which the image shows a radius
};

/// The tube about a way: its middle line and where the image falls to half between the middle and what is
/// about the tube. Where that cannot be seen the line stays and the radius comes from the nearest places.
/// @param way voxels, as cheapest_way() says. @param part lightly smoothed, 14 mm about the way.
/// @param smallest_mm, largest_mm limits of the radius; the smallest one where none is seen.
Tube tube_about(const Image& image, const Part& part, const std::vector<Eigen::Vector3i>& way,
                const Looks& looks, double smallest_mm, double largest_mm);

}  // namespace glisson::editing
