// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "glisson/engine/command.h"

namespace glisson::engine {

/// Somebody sees that the organ is where the registration thought it less probable
/// (registration::choose_rival). Chosen once more, the former place is back.
struct ChooseRival {
  std::size_t rival = 0;  ///< of Registration::rivals
  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
