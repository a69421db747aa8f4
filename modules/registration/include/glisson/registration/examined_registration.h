// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/patient/sound_cloud.h"
#include "glisson/registration/error_model.h"
#include "glisson/registration/findings.h"
#include "glisson/registration/register_model.h"

namespace glisson::registration {

/// A model registered, and what is known of how wrong it is: what register_model() gives.
struct ExaminedRegistration {
  Registered registered;  ///< its doubts hold what the findings amount to; `refused` (refusal.h) comes first
  Findings findings;
  std::shared_ptr<const ErrorModel> error;  ///< what is not known of any point's place
  std::vector<LesionError> lesions;         ///< of the model
  CloudFaults cloud_faults;                 ///< of the cloud and of other looks
};

}  // namespace glisson::registration
