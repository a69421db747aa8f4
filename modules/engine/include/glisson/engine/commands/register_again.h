// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/registration/register_model.h"

namespace glisson::engine {

/// Registers again while the organ is followed, with what has been seen of it since
/// (registration::register_again), and offers the result. Tracking goes on from the former one.
struct RegisterAgain : registration::RegisterOptions {
  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
