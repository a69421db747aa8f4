// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/engine/parts/check.h"

namespace glisson::engine {

/// A person has looked at the model.
struct CheckModel {
  ModelCheck check;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
