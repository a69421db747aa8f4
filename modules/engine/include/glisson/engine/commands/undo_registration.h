// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"

namespace glisson::engine {

/// The registration and the one that it has replaced change places. Done once more, the later one is back.
struct UndoRegistration {
  CommandTraits traits() const;
  /// @throws InputError model, landmarks, stiffness or points are others by now.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
