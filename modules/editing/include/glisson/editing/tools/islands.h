// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "glisson/editing/tool.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// Parts of a label that do not share a face. Erases.
struct Islands {
  static const ToolKind& kind();
  enum class Operation {
    keep_largest,
    remove_small,  ///< below `smallest_ml`
    keep_clicked,
    remove_clicked,
    /// Each but the largest becomes a label of its own, by falling size: the next free lesion for a lesion,
    /// else the next free "other" label. When none is free the rest stay (note "islands_left:3").
    split
  };
  Label label = structure::kParenchyma;
  Operation operation = Operation::keep_largest;
  double smallest_ml = 1.0;
  Eigen::Vector3d p_in_ct = Eigen::Vector3d::Zero();

  bool operator==(const Islands&) const = default;
};

}  // namespace glisson::editing
