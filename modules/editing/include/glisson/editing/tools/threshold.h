// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/editing/tool.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// Everything between two intensities becomes `label`. Overwrites.
struct Threshold {
  static const ToolKind& kind();
  Label label = structure::kParenchyma;
  double low = 100.0, high = 300.0;  ///< Hounsfield units, inclusive
  bool replace = false;              ///< what `label` had before is lost

  bool operator==(const Threshold&) const = default;
};

}  // namespace glisson::editing
