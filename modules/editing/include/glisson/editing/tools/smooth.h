// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/editing/tool.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// Evens a label's surface: reshapes. Joint: evens those of all labels, which take voxels from each other.
struct Smooth {
  static const ToolKind& kind();
  enum class Method {
    median,   ///< majority in a ball (of its voxels inside the volume)
    closing,  ///< fills what a ball of the radius cannot enter
    opening,  ///< takes what a ball cannot fill
    joint     ///< all labels at once, without gaps between them; each keeps its volume and thin branches
  };
  Label label = structure::kParenchyma;  ///< not for joint
  Method method = Method::median;
  double radius = 3e-3;

  bool operator==(const Smooth&) const = default;
};

}  // namespace glisson::editing
