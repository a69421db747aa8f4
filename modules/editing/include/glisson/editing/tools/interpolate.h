// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/editing/tool.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// Fills the slices between those where something is drawn (Raya and Udupa 1990: mean of signed distances).
/// Reshapes. Note "no_slices_between".
struct InterpolateSlices {
  static const ToolKind& kind();
  Label label = structure::kParenchyma;
  int normal_axis = 2;

  bool operator==(const InterpolateSlices&) const = default;
};

}  // namespace glisson::editing
