// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"

namespace glisson::engine {

/// Takes the last correction of the tracked organ back.
struct UndoCorrection {
  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context,
                             const Services& services) const;
};

}  // namespace glisson::engine
