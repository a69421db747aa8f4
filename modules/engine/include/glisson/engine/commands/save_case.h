// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/command.h"
#include "glisson/engine/commands/open_case.h"

namespace glisson::engine {

/// `path` empty: where the case was opened from or last saved.
struct SaveCase {
  using Result = CaseOnDisk;
  std::filesystem::path path;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
