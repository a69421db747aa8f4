// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/registration/register_model.h"

namespace glisson::engine {

/// Brings the model to the cloud (see registration::register_model). Whether
/// landmarks are placed the case says, and how stiff the tissue is where the command says nothing of it.
struct Register : registration::RegisterOptions {
  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
