// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/engine/case_state.h"
#include "glisson/model/build.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/operation_prior.h"

namespace glisson::engine {

/// Operations simulated for a registration, and what they were simulated on: the next registration of the
/// same patient needs no others.
struct SimulatedOperations {
  std::shared_ptr<const model::BuiltModel> model;
  std::shared_ptr<const Landmarks> landmarks;
  registration::OperationOptions options;
  std::shared_ptr<const registration::OperationPrior> prior;
};

namespace part {
/// Where the model lies in the camera's frame.
extern const PartOf<Registration> registration;
/// Comes with a registration; not in the files.
extern const PartOf<SimulatedOperations> operations;
}  // namespace part

}  // namespace glisson::engine
