// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/command.h"
#include "glisson/engine/commands/open_case.h"

namespace glisson::engine {

/// `path` empty: where the case was opened from or last saved. A case that another program has open for
/// writing is left alone, with who has it. Where others have saved since it was opened here, theirs stays and
/// this one is saved beside, as "NAME (2).glisson", which the note "case.saved_beside FOLDER" tells.
/// @throws InputError in apply(): another case lies there, and nobody has said that it is to be replaced.
struct SaveCase {
  using Result = CaseOnDisk;
  std::filesystem::path path;
  bool replaces = false;  ///< another case that lies there

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
