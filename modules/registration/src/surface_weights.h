// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/registration/pairs.h"

namespace glisson::registration {

/// No point stands for more than so many times the median: beside holes and borders the disc up to a point's
/// neighbours takes in what was not seen.
inline constexpr double kMostOfMedian = 3.0;

/// Area that a point stands for: the disc up to its k-th neighbour, over k, m2. @param neighbours nearest
/// first, one at least.
double area_of_point(const Points& points, Eigen::Index point, const std::vector<int>& neighbours);

/// What each point stands for on the surface, whatever it is labelled, as PreparedCloud::weight for points of
/// the surface: what lies on the margin or beside the notch lies on the surface as exactly as any other
/// point, so that a label must take nothing away from what its point says there.
/// @pre of a cloud prepared with the default reference density.
std::vector<double> surface_weights(const PreparedCloud& cloud);

}  // namespace glisson::registration
