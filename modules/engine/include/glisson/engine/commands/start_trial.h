// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/engine/load_trial.h"

namespace glisson::engine {

/// From now on a load can be tried on the model (see Engine::submit_pull). Changes no part; another model or
/// other landmarks end it.
struct StartTrial {
  TrialOptions options;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context,
                             const Services& services) const;
};

}  // namespace glisson::engine
