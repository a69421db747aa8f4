// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"

namespace glisson::engine {

/// Somebody sees a place of the tracked organ elsewhere than it is drawn: the model goes there, and goes on
/// from there. Which corrections stand the live part says.
struct CorrectTracking {
  Correction correction;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context,
                             const Services& services) const;
};

}  // namespace glisson::engine
