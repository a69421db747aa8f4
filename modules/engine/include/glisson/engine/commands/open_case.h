// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/case_state.h"
#include "glisson/engine/command.h"

namespace glisson::engine {

/// What stands on the disk after a save, or after opening: the case may have gone on meanwhile.
struct CaseOnDisk {
  Editions editions;
};

struct OpenCase {
  using Result = CaseOnDisk;
  std::filesystem::path path;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
