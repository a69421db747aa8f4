// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "glisson/registration/contact_forces.h"
#include "glisson/registration/register.h"
#include "shape_fits.h"

namespace glisson::registration {

/// A cloud with its looks moved; as it is where it has one.
LabelledCloud as_looked(const LabelledCloud& cloud, const LookMotions& looks);

/// The most probable forces and what they make of the model, with the doubts that register_model() names.
/// @param shapes where operations are known: their modes and the forces of tools are found together, from the
/// most probable shape and, without any, from the rigid starts.
/// @param start where there are no shapes. @param forces what is known of them besides the model
/// and `elastic`.
/// @param pose_known of the start. @param[out] fit of which the registration was made.
Cancellable<Registration> register_by_forces(const PatientModel& model, const LabelledCloud& cloud,
                                             CameraFromCt start, const ElasticOptions& elastic,
                                             const std::optional<ShapeFits>& shapes,
                                             ContactForceOptions forces, bool pose_known,
                                             std::optional<ContactForceFit>& fit, const RunContext& context);

}  // namespace glisson::registration
