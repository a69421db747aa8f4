// SPDX-License-Identifier: GPL-3.0-or-later
#include "installed.h"

#include <system_error>

namespace glisson {
namespace fs = std::filesystem;

std::optional<fs::path> program_folder() {
  std::error_code failure;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  if (failure) return std::nullopt;
  return program.parent_path();
}

}  // namespace glisson
