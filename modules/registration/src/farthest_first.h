// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/geometry/mesh.h"

namespace glisson::registration {

/// Points spread evenly over others.
struct Spread {
  std::vector<Eigen::Index> chosen;  ///< rows, in the order in which they were chosen
  std::vector<std::size_t> nearest;  ///< of each row: which of `chosen` is the nearest
};
/// `first`, then the farthest from those chosen so far, until none is farther than `spacing`, metres. Empty
/// for no points.
Spread farthest_first(const Points& points, double spacing, Eigen::Index first = 0);

}  // namespace glisson::registration
