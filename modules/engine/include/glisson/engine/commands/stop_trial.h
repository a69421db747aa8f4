// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"

namespace glisson::engine {

/// Ends the load trial; does nothing where none is on.
struct StopTrial {
  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
