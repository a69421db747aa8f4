// SPDX-License-Identifier: GPL-3.0-or-later
#include "penalty.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glisson/core/error.h"

namespace glisson::registration {

double stiffness_at_plateau(double k_min, double k_max, int r, int n) {
  require(r > 0 && n >= 0, "eq. 15 needs r > 0 and n >= 0");
  if (n >= r) return k_max;
  const double ratio = static_cast<double>(n) / r, square = ratio * ratio;
  return k_min + 2.0 * (k_max - k_min) * square / (square + 1.0);
}

double penalty_force(PenaltyForm form, double s, double d) {
  require(s > 0.0 && d >= 0.0, "eq. 14 needs s > 0 and d >= 0");
  switch (form) {
    case PenaltyForm::corrected:
      return d * (1.0 - 2.0 / std::numbers::pi * std::atan(s * d));
    case PenaltyForm::clamped:
      return std::max(0.0, 1.0 - std::atan(s * d)) / s;
    case PenaltyForm::printed:
      return -(1.0 - std::atan(s * d)) / s;
  }
  return 0.0;
}

}  // namespace glisson::registration
