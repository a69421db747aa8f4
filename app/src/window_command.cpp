// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli.h"
#include "commands.h"
#include "glisson/ui/shell/run_window.h"

namespace glisson::app {

int run_window(int argc, char** argv) {
  if (argc > 2) throw UsageError("the window opens one case. See 'glisson --help'.");
  const std::filesystem::path path = argc > 1 ? argv[1] : "";
  if (!path.empty() && !std::filesystem::exists(path))
    throw FileError(path.string() + ": does not exist, and is no command. See 'glisson --help'.");
  if (!has_display() && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
    throw UsageError(
        "there is no display for the window, but commands work without one. See 'glisson --help'.");
  return ui::run_window(argc, argv, path);
}

}  // namespace glisson::app
