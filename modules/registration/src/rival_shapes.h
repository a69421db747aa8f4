// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/registration/shape_fit.h"

namespace glisson::registration {

/// Whether two fits are two answers and not nearly the same one: their nodes lie more than 10 mm apart in the
/// mean.
inline bool are_rivals(const ShapeFit& a, const ShapeFit& b) {
  constexpr double kApart = 10e-3;
  return (a.nodes_in_camera - b.nodes_in_camera).rowwise().norm().mean() > kApart;
}

}  // namespace glisson::registration
