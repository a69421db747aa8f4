// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/editing/tool.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// Background that the label encloses. Reshapes.
struct FillHoles {
  static const ToolKind& kind();
  Label label = structure::kParenchyma;
  bool in_slices = false;  ///< holes of one slice count, too (in any of the three axes)

  bool operator==(const FillHoles&) const = default;
};

}  // namespace glisson::editing
