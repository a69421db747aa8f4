// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/engine/command.h"
#include "glisson/patient/registration.h"

namespace glisson::engine {

/// Somebody wants to go on with a registration that was refused. Its doubts stay with it.
struct AcceptRegistration {
  /// The one that the person has looked at; null: whatever the case holds.
  std::shared_ptr<const Registration> seen = {};

  CommandTraits traits() const;
  /// @throws InputError `seen` is not what the case holds.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
