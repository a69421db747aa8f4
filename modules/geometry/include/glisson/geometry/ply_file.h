// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
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
/// @throws FileError missing; InputError naming the header's line or the element's row ("vertex 17"): not a
/// PLY, unknown entry or type, not a number, truncated.
std::vector<PlyElement> read_ply(const std::filesystem::path& path);
/// The same from memory. @param name stands in messages.
std::vector<PlyElement> parse_ply(std::string_view content, const std::string& name);

/// Appends a number's bytes as binary_little_endian files hold them.
template <class T>
void append_little_endian(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if constexpr (std::endian::native != std::endian::little) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

}  // namespace glisson
