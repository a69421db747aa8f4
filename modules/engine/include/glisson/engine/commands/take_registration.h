// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "glisson/engine/command.h"
#include "glisson/engine/parts/other_registration.h"

namespace glisson::engine {

/// The other registration and the one from which the organ is followed change places, and what follows goes
/// over to it. Done once more, the former one is back.
struct TakeRegistration {
  /// The other one, of which the person has read; null: whatever the case holds.
  std::shared_ptr<const OtherRegistration> seen = {};

  CommandTraits traits() const;
  /// @throws InputError `seen` is not what the case holds; the organ is not followed just now, or cannot be
  ///   from there; nothing has changed.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context,
                             const Services& services) const;
};

/// What whoever registers again goes over to unasked: a registration that is better by its evidence. Empty:
/// the case holds none, it is no better, or it is the former one; that is left to a person.
std::optional<TakeRegistration> take_if_better(const CaseState& state);

}  // namespace glisson::engine
