// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "glisson/engine/case_state.h"
#include "glisson/model/build.h"
#include "glisson/registration/register_model.h"

namespace glisson::engine {

/// Operations simulated on this patient's liver, and what they were simulated on: every registration of the
/// same model rests on them.
struct SimulatedOperations {
  std::shared_ptr<const model::BuiltModel> model;
  std::shared_ptr<const Landmarks> landmarks;
  registration::OperationOptions options;
  std::uint64_t seed = 1;
  std::shared_ptr<const registration::OperationPrior> prior;
};

namespace part {
extern const PartOf<SimulatedOperations> operations;
}  // namespace part

/// Whether there are some, of the model and the landmarks as they are now.
bool has_operations(const CaseState& state);
/// `options` with the stiffness that the case's tissue has been given; without any as they are.
registration::OperationOptions with_tissue_of(const CaseState& state, registration::OperationOptions options);
/// Those of the model and the landmarks as they are now, of this seed; none: a null prior.
registration::KnownOperations known_operations(const CaseState& state, std::uint64_t seed);
/// Keeps them as simulated on the model and the landmarks as they are now.
void keep_operations(CaseState& state, const registration::OperationOptions& options, std::uint64_t seed,
                     std::shared_ptr<const registration::OperationPrior> prior);

}  // namespace glisson::engine
