// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/registration/operation_prior.h"

namespace glisson::engine {

/// Simulates operations on the case's model ahead of its registration, which then rests on them
/// (registration::simulate_operations), with the stiffness that the case's tissue has been given. Where they
/// are there already nothing changes.
struct SimulateOperations : registration::OperationOptions {
  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

/// Whether SimulateOperations has anything to do and can do it: there are no operations of this model,
/// nothing stands in the way, and the vena cava is known.
bool lacks_operations(const CaseState& state);

}  // namespace glisson::engine
