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

/// Where something nearer than predicted is the organ itself, lifted or swollen, and nothing in front of it.
/// A connected patch is the organ's if its depth passes into the surrounding organ's without a step, or if
/// points are followed on it about as densely as elsewhere. A tool has a step all around but at its tip, and
/// no point begins on it. One decision a place, row by row.
std::vector<char> lifted_places(const SeenGrid& grid);

}  // namespace glisson::guidance
