// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdlib.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "glisson/core/files.h"

namespace glisson::test {

/// While it is there, what Glisson keeps of itself (state_folder()) goes to a new place: nobody has entered
/// anything here yet.
class StateFolder {
 public:
  StateFolder() {
    if (const char* before = std::getenv("XDG_STATE_HOME")) before_ = before;
    ::setenv("XDG_STATE_HOME", folder_.path().c_str(), 1);
  }
  ~StateFolder() { before_ ? ::setenv("XDG_STATE_HOME", before_->c_str(), 1) : ::unsetenv("XDG_STATE_HOME"); }
  StateFolder(const StateFolder&) = delete;
  StateFolder& operator=(const StateFolder&) = delete;
  /// As state_folder() says it; made when something is kept.
  std::filesystem::path path() const { return folder_.path() / "glisson"; }

 private:
  TemporaryFolder folder_;
  std::optional<std::string> before_;
};

}  // namespace glisson::test
