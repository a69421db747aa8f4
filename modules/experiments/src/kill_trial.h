// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"

namespace glisson::experiments {

/// How often the program was killed at work, and what was found afterwards.
struct KillTrial {
  int kills = 0;  ///< that came while it was at work
  int came_through = 0;
  int littered = 0;   ///< kills that left something behind, until the next start
  int recovered = 0;  ///< recordings that were cut off and kept under another name
  int broken = 0;     ///< neither the old state nor the new one
  int left = 0;       ///< things left after the next start; must be none

  bool passed() const { return broken == 0 && left == 0; }
  /// Each as `kill_...`.
  Figures figures() const;
};

/// Starts the program (`glisson`) on work in a folder of its own, over and over, and ends it by SIGKILL at
/// random moments: import into a case (which saves it), and recording the overlay of `patient` when it is not
/// empty. After each kill the case must open as it was before or after, the recording be the former one or a
/// whole new one, and once the program has run again in peace nothing else may be in the folder.
/// @param folder an existing, empty one. @return empty when cancelled.
/// @throws FileError the program cannot be started; Error it fails in peace.
Cancellable<KillTrial> kill_at_work(const std::filesystem::path& program, const std::filesystem::path& folder,
                                    const std::filesystem::path& patient, int kills,
                                    const RunContext& context);

}  // namespace glisson::experiments
