// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/registration/moving_surface.h"
#include "glisson/registration/pairs.h"

namespace glisson::registration {

/// What speaks against a place of the organ because a margin that the cloud would show is not marked: a
/// person who marks the margin marks it where it is seen, and leaves one of five places of 25 mm out. Who has
/// marked none at all may not have wanted to: that counts as one place left out. A cloud without labels was
/// not asked.
/// @param surface the model's where it is, in the cloud's frame.
/// @param information of a point, as ShapeFitOptions::information: what is left out is an act of its own, not
/// a neighbour's error, and so counts as much as all votes of a place (rivals.h).
/// @return twice the negative logarithm of the probability, as ShapeFit::cost; at least 0.
double unmarked_cost(const PatientModel& model, const PreparedCloud& cloud, const MovingSurface& surface,
                     double information);

}  // namespace glisson::registration
