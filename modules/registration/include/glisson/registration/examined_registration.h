// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/patient/sound_cloud.h"
#include "glisson/registration/error_model.h"
#include "glisson/registration/findings.h"
#include "glisson/registration/register_model.h"

namespace glisson::registration {

/// A model registered, and what is known of how wrong it is.
struct ExaminedRegistration {
  Registered registered;  ///< its doubts hold what the findings amount to; `refused` (refusal.h) comes first
  Findings findings;
  std::shared_ptr<const ErrorModel> error;  ///< what is not known of any point's place
  std::vector<LesionError> lesions;         ///< of the model
  CloudFaults cloud_faults;                 ///< of the cloud and of other looks
};

/// The door by which a model is registered: register_model() with what it knows of itself. Where a prior is
/// known and the start is sought, the cloud's mirror image is registered, too. What is no point of the cloud
/// is left out (sound_cloud(); zeros unless the cloud is in the model's frame).
/// @throws InputError, NumericalError as register_model.
Cancellable<ExaminedRegistration> register_and_examine(const PatientModel& model, const LabelledCloud& cloud,
                                                       const RegisterOptions& options,
                                                       const RunContext& context,
                                                       const KnownOperations& known = {});

}  // namespace glisson::registration
