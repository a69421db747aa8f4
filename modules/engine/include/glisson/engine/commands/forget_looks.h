// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"

namespace glisson::engine {

/// The organ has moved, or another one is looked at: earlier looks are joined no more.
struct ForgetLooks {
  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
