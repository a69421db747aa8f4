// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/editing/tool.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// Grows (positive) or shrinks (negative) by a distance between voxel centres. Reshapes.
struct Margin {
  static const ToolKind& kind();
  Label label = structure::kParenchyma;
  double distance = 3e-3;

  bool operator==(const Margin&) const = default;
};

}  // namespace glisson::editing
