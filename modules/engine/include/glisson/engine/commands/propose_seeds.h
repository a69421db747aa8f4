// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"

namespace glisson::engine {

/// Seeds for a liver that nobody has clicked yet; the other seeds stay.
struct ProposeSeeds {
  CommandTraits traits() const;
  /// @throws InputError there are seeds in the liver; as segmentation::propose_liver_seeds().
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
