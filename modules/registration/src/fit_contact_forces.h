// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/registration/contact_forces.h"

namespace glisson::registration {

/// The one cloud by contact forces (contact_forces.h).
/// @param start where the model's rest shape is before the camera; stays where nodes are fixed or it is
/// known.
/// @throws InputError fewer than 10 points, not finite, options, mesh, fixed nodes out of range;
/// NumericalError when no law has an equilibrium.
Cancellable<ContactForceFit> fit_contact_forces(const PatientModel& model, const LabelledCloud& cloud,
                                                const CameraFromCt& start, const ContactForceOptions& options,
                                                const RunContext& context);

}  // namespace glisson::registration
