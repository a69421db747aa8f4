// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/core/run_context.h"
#include "glisson/engine/case_state.h"
#include "glisson/fem/load_trial.h"

/// @file
/// A load tried on the patient's model, live: a point of the surface is pulled and the organ follows. It is a
/// trial: nothing of the case changes.

namespace glisson::engine {

using fem::LoadTrial;
using fem::TrialOptions;
using fem::TrialPull;
using fem::TrialState;

/// Implicit Euler on the composite model of the case, held at its vena cava and where its vessels enter; the
/// springs that hold it are damped like the tissue. Empty: cancelled.
/// @pre a model (the engine asks for what is in a command's way before).
/// @throws InputError a model without tetrahedra, nothing known that holds it, or only
/// places on one line, options out of range.
Cancellable<std::unique_ptr<LoadTrial>> make_load_trial(const CaseState& state, const TrialOptions& options,
                                                        const RunContext& context);

}  // namespace glisson::engine
