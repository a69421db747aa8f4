// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/geometry/mesh.h"

namespace glisson::segmentation {

/// The click's number among these, from 1; where it is none of them, the next one's. A file holds
/// millimetres, and saving and reading may change a metre's last bit; no hand clicks within a thousandth of a
/// millimetre of where it clicked before.
inline Eigen::Index click_number(const Points& clicks, const Eigen::RowVector3d& p) {
  constexpr double kSame = 1e-6;  // metres
  Eigen::Index n = 0;
  while (n < clicks.rows() && !((clicks.row(n) - p).norm() < kSame)) ++n;
  return n + 1;
}

/// Whether one of these clicks is this one.
inline bool holds_click(const Points& clicks, const Eigen::RowVector3d& p) {
  return click_number(clicks, p) <= clicks.rows();
}

}  // namespace glisson::segmentation
