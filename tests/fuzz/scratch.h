// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <stdexcept>
#include <string_view>

#include "glisson/core/error.h"
#include "glisson/core/files.h"

namespace glisson::fuzz {

/// Puts the bytes into a file of that name, reads it, and lets no Error out that a person could act on.
template <class Read>
void read_file_of(const char* name, std::string_view bytes, Read read) {
  static const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / name;
  std::ofstream(path, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  try {
    read(path);
  } catch (const InputError& error) {
    if (error.remedy().empty())
      throw std::logic_error(std::string("refused without a remedy: ") + error.what());
  } catch (const FileError&) {
    return;
  }
}

/// What was read although it cannot be.
inline void must(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

}  // namespace glisson::fuzz
