// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/engine/recovery.h"

namespace glisson::engine {

/// Opens the copy of a case that a program left behind, in place of the case that is open. It belongs where
/// the case was; nothing is saved there until somebody asks for it, and not over what was saved there since.
struct RecoverCase {
  Recoverable copy;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
