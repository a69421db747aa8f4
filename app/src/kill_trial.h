// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "cli.h"

namespace glisson::app {

/// How often the program was killed at work, and what was found afterwards.
struct KillTrial {
  int kills = 0;  ///< that came while it was at work
  int came_through = 0;
  int littered = 0;   ///< kills that left something behind, until the next start
  int recovered = 0;  ///< recordings that were cut off and kept under another name
  int broken = 0;     ///< neither the old state nor the new one
  int left = 0;       ///< things left after the next start; must be none
};

/// Starts the program on work in a folder of its own, over and over, and ends it by SIGKILL at random
/// moments: import into a case (which saves it), and recording the overlay of `patient` when it is not empty.
/// After each kill the case must open as it was before or after, the recording be the former one or a whole
/// new one, and once the program has run again in peace nothing else may be in the folder.
/// @throws FileError, Interrupted.
KillTrial kill_at_work(const std::filesystem::path& folder, const std::filesystem::path& patient, int kills,
                       const RunContext& context);

}  // namespace glisson::app
