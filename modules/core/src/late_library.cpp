// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/late_library.h"

#include <dlfcn.h>

#include <filesystem>
#include <optional>

#include "installed.h"

namespace glisson {
namespace fs = std::filesystem;

MissingLibrary::MissingLibrary(const std::string& path)
    : FileError(path + ": a library of Glisson is missing or cannot be loaded. Install Glisson again.") {}

const void* late_symbol(const std::string& library, const std::string& symbol) {
  const std::optional<fs::path> folder = program_folder();
  if (!folder) throw MissingLibrary(library);
  const fs::path path = folder->parent_path() / "lib/glisson" / library;
  void* loaded = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  const void* found = loaded == nullptr ? nullptr : ::dlsym(loaded, symbol.c_str());
  if (found == nullptr) throw MissingLibrary(path.string());
  return found;
}

}  // namespace glisson
