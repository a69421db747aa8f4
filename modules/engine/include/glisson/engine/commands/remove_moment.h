// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"

namespace glisson::engine {

/// Deletes a kept moment. KeepMoment with the same value brings it back.
/// @throws InputError there is none of this number.
struct RemoveMoment {
  int number = 0;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
