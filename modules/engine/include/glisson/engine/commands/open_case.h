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

/// Puts another case in place of this one. Open for writing it is held against other programs until it is
/// closed.
struct OpenCase {
  /// `either`: for writing if nobody else has it, otherwise for reading, which the note
  /// "case.open_for_reading WHO", or "case.folder_not_writable", tells.
  enum class Access { write, read, either };
  using Result = CaseOnDisk;
  std::filesystem::path path;
  Access access = Access::either;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
