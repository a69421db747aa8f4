// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/editing/tool.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// Set algebra on labels. As no voxel has two, add and copy take the voxels from the other label, subtracting
/// another label changes nothing and intersecting with another leaves nothing; inverting and filling
/// overwrite whatever the region lets them.
struct Logical {
  static const ToolKind& kind();
  enum class Operation { copy, add, subtract, intersect, invert, clear, fill };
  Label label = structure::kParenchyma;
  Operation operation = Operation::add;
  Label other = structure::kBackground;  ///< for copy, add, subtract, intersect

  bool operator==(const Logical&) const = default;
};

}  // namespace glisson::editing
