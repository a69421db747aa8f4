// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/registration/register.h"
#include "shape_fits.h"

namespace glisson::registration {

/// Initial elastic registration (paper 2.2.3; eq. 14 and 15 as the README corrects them): label-restricted
/// closest points, implicit Euler steps, plateaus of kinetic energy and mean residual, stop at max(r) + 1.
/// Registration::residual is the mean over the pairs kept (outliers excluded).
/// Doubts: few_margin_points, little_surface_seen (under a fifth of the model's), many_outliers,
/// residual_large, inverted_elements, pull_not_at_rest (the most steps were done), mechanics_failed.
/// @pre no options.prior. @throws InputError fewer than 10 points, not finite, hardly any of which meet the
/// model from `start`; unusable options or mesh; fixed nodes out of range.
Cancellable<Registration> register_elastic(const PatientModel& model, const LabelledCloud& cloud,
                                           const CameraFromCt& start, const ElasticOptions& options,
                                           const RunContext& context);

/// The same from the most probable of shapes that were fitted before, with their doubts. A shape that would
/// turn elements inside out is taken back as far as needed, with the doubt shape_inverted.
/// @pre options.prior, which the shapes rest on.
Cancellable<Registration> register_elastic(const PatientModel& model, const LabelledCloud& cloud,
                                           const ShapeFits& shapes, const ElasticOptions& options,
                                           const RunContext& context);

}  // namespace glisson::registration
