// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"

namespace glisson::engine {

/// The other registration and the one from which the organ is followed change places, and what follows goes
/// over to it. Done once more, the former one is back.
struct TakeRegistration {
  CommandTraits traits() const;
  /// @throws InputError the organ is not followed just now, or cannot be from there; nothing has changed.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context,
                             const Services& services) const;
};

}  // namespace glisson::engine
