// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "glisson/engine/command.h"
#include "glisson/patient/registration.h"

namespace glisson::engine {

/// Somebody sees that the organ is where the registration thought it less probable
/// (registration::choose_rival). Chosen once more, the former place is back.
struct ChooseRival {
  std::size_t rival = 0;  ///< of Registration::rivals
  /// The registration whose rivals the person has looked at; null: whatever the case holds.
  std::shared_ptr<const Registration> seen = {};

  CommandTraits traits() const;
  /// @throws InputError `seen` is not what the case holds, or there is no such rival.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
