// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include "glisson/engine/command.h"
#include "glisson/volume/label_volume.h"

namespace glisson::engine {

/// Replaces what is locked (see part::locks).
struct SetLocks {
  std::set<Label> locked;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
