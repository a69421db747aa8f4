// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>

namespace glisson::test {

/// Where the real data lies: what GLISSON_DATA names, else beside the checkout. Empty when nobody says.
inline std::filesystem::path data_folder() {
  if (const char* named = std::getenv("GLISSON_DATA")) return named;
  const char* source = std::getenv("GLISSON_SOURCE_DIR");
  return source != nullptr ? std::filesystem::path(source) / "../shared/data" : std::filesystem::path();
}

}  // namespace glisson::test
