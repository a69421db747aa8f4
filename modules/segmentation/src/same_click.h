// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "glisson/geometry/mesh.h"

namespace glisson::segmentation {

/// Whether one of these clicks is this one. A file holds millimetres, and saving and reading may change a
/// metre's last bit; no hand clicks within a thousandth of a millimetre of where it clicked before.
inline bool holds_click(const Points& clicks, const Eigen::RowVector3d& p) {
  constexpr double kSame = 1e-6;  // metres
  const auto rows = clicks.rowwise();
  return std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return (row - p).norm() < kSame; });
}

}  // namespace glisson::segmentation
