// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace glisson {

/// By how much the gap between two slices may differ from the usual one and be the same, mm. Places are often
/// rounded to a tenth of a millimetre: two gaps of 0.625 mm are 0.6 and 0.7 then. A quarter at most, so that
/// of thin slices, too, none can be missing.
inline double gap_tolerance_mm(double usual_mm) {
  return std::max({0.05 * usual_mm, 0.06, std::min(0.101, 0.25 * usual_mm)});
}

}  // namespace glisson
