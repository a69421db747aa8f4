// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/command.h"

namespace glisson::engine {

/// Saves the case as it is to a recovery folder, and leaves the case and its own place alone.
struct KeepCopy {
  std::filesystem::path folder;  ///< RecoveryFolder::path()

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
