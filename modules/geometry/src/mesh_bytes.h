// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "glisson/core/error.h"
#include "glisson/core/files.h"

namespace glisson {

/// A whole mesh file. @throws FileError; InputError larger than the mesh of an organ can be: parsers need a
/// dozen bytes for each of the file's.
inline std::string mesh_bytes(const std::filesystem::path& path) {
  constexpr std::size_t kMost = 300000000;
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(path, failure);
  if (!failure && size > kMost)
    throw InputError(path.string(), "", "is larger than 300 MB, more than the mesh of an organ needs",
                     "Make the mesh coarser, or save it in binary");
  return read_file(path, kMost);
}

/// Points, cells or rows that one file may hold: the surface of a liver from a fine CT has half a million
/// triangles. Each costs some hundred bytes, so that no file takes more than about a gigabyte or some
/// seconds.
constexpr long kMostRows = 5000000;

/// @throws InputError more rows than a mesh needs.
inline void check_rows(const std::string& name, const std::string& field, double rows) {
  if (rows > static_cast<double>(kMostRows))
    throw InputError(name, field,
                     "holds more than " + std::to_string(kMostRows) +
                         " points or cells, more than the mesh of an organ needs",
                     "Make the mesh coarser");
}

}  // namespace glisson
