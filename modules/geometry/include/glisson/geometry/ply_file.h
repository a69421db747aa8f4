// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace glisson {

/// One element of a PLY file ("vertex", "face"): scalar properties as columns, list properties as rows of
/// their own. Every number is held as a double, which is exact for all PLY types.
struct PlyElement {
  std::string name;
  long count = 0;
  std::map<std::string, std::vector<double>> scalars;             ///< count values each
  std::map<std::string, std::vector<std::vector<double>>> lists;  ///< count lists each
};

/// Parses a PLY file: ascii or binary, either endianness. Our own parser, because VTK's crashes on malformed
/// files; it trusts no count of the header beyond what the file's size allows.
/// @throws FileError missing; InputError naming the line or element: not a PLY, unknown type, truncated.
std::vector<PlyElement> read_ply(const std::filesystem::path& path);
/// The same from memory. @param name stands in messages.
std::vector<PlyElement> parse_ply(std::string_view content, const std::string& name);

}  // namespace glisson
