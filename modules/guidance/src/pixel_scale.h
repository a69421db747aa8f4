// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace glisson::guidance {

/// Limits in pixels are those of pictures up to so wide. In larger ones the same scope's angles have more
/// pixels, and so has what calibration, optics and motion leave: there the limits are multiplied by this.
/// @return 1 and more.
inline double pixel_scale(int width) {
  constexpr double kWidest = 960.0;
  return std::max(1.0, width / kWidest);
}

}  // namespace glisson::guidance
