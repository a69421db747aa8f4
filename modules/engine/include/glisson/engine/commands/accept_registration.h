// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"

namespace glisson::engine {

/// Somebody wants to go on with a registration that was refused. Its doubts stay with it.
struct AcceptRegistration {
  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
