// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "glisson/editing/tool.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// What hangs on a tree beyond the thinnest place near a click, seen from the tree's root, goes to another
/// label.
struct ReassignBranch {
  static const ToolKind& kind();
  Label label = structure::kPortalVein;  ///< that loses it
  /// kBackground: is cut off, and becomes parenchyma or background as what a reshaped label loses.
  Label to = structure::kHepaticVeins;
  Eigen::Vector3d p_in_ct = Eigen::Vector3d::Zero();

  bool operator==(const ReassignBranch&) const = default;
};

}  // namespace glisson::editing
