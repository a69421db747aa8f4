// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/editing/tool.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// Labels compete from the voxels that they have for the unlabelled voxels about them: along paths of little
/// difference in intensity (a shortest-path form of GrowCut; Zhu 2014). A step costs the square of the
/// difference of two neighbours in the image after a median of three along each axis, and 5 HU^2 for each mm.
struct GrowFromSeeds {
  static const ToolKind& kind();
  /// One or more that may grow, and with the rivals two or more; kBackground cannot be one.
  std::vector<Label> labels;
  double reach = 20e-3;  ///< no farther from a seed than this
  /// Labels that only compete: what they win is given back ("not this").
  std::vector<Label> rivals;

  bool operator==(const GrowFromSeeds&) const = default;
};

}  // namespace glisson::editing
