// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "glisson/editing/tool.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// The region of like intensity around a click in one slice, without holes, bounded by the iso-line through
/// the click in the slice smoothed by a binomial of five. Of the two sides of the line the one that does not
/// reach the slice's edge, else the smaller one (note "level_tracing.open"). Overwrites; erases.
struct LevelTracing {
  static const ToolKind& kind();
  Label label = structure::kParenchyma;
  bool erase = false;
  int normal_axis = 2;
  Eigen::Vector3d p_in_ct = Eigen::Vector3d::Zero();

  bool operator==(const LevelTracing&) const = default;
};

}  // namespace glisson::editing
