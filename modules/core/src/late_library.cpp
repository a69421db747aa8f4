// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/late_library.h"

#include <dlfcn.h>

#include <system_error>

#include "glisson/core/error.h"

namespace glisson {
namespace fs = std::filesystem;

const void* late_symbol(const std::string& library, const fs::path& built, const std::string& symbol) {
  std::error_code failure;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  fs::path path = program.parent_path().parent_path() / "lib/glisson" / library;
  if (!fs::is_regular_file(path, failure) && fs::is_regular_file(built, failure)) path = built;
  void* loaded = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  const void* found = loaded == nullptr ? nullptr : ::dlsym(loaded, symbol.c_str());
  if (found == nullptr)
    throw FileError(path.string() +
                    ": a library of Glisson is missing or cannot be loaded. Install Glisson again.");
  return found;
}

}  // namespace glisson
