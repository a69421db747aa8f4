// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>

#include "glisson/ui/common/view_state.h"

namespace glisson::ui {

/// A circle in a slice, closed corner by corner.
struct SliceCircle {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();                            ///< CT frame, metres
  double radius = 0.0;                                                         ///< metres
  Eigen::Vector3d u = Eigen::Vector3d::UnitX(), v = Eigen::Vector3d::UnitY();  ///< span it, of length one
  int corners = 32;
};
/// @param gesture its slice is the circle's. @param label whose colour it has.
std::shared_ptr<const SliceLine> line_of(const SliceCircle& circle, const SliceGesture& gesture, Label label);

}  // namespace glisson::ui
