// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace glisson::guidance {

/// What stereo shows at the places of a grid, row by row.
struct SeenGrid {
  int columns = 0, rows = 0;
  std::vector<double> range, sigma;     ///< along the ray, metres; range 0: nothing is seen
  std::vector<char> predicted, nearer;  ///< the organ should be seen; what is seen lies nearer than it
  std::vector<int> followed;            ///< points followed there
};

/// Where what lies nearer than predicted is the organ itself, lifted or swollen, and not something before it.
/// A patch of places side by side is the organ's if its depth goes over into the organ's around it without a
/// step, or if points are followed on it about as densely as on the rest. A tool has a step all around, but
/// for its tip, and no point begins on it. One decision a place.
std::vector<char> lifted_places(const SeenGrid& grid);

}  // namespace glisson::guidance
