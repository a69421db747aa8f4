// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/registration/register.h"

namespace glisson::registration {

/// Eq. 15. @param n plateau index. @pre r > 0, n >= 0.
double stiffness_at_plateau(double k_min, double k_max, int r, int n);
/// Eq. 14's force over k at distance d, metres, positive towards the cloud. @pre s > 0, d >= 0.
double penalty_force(PenaltyForm form, double s, double d);

}  // namespace glisson::registration
