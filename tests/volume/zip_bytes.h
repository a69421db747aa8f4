// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "zip_deflate.h"

namespace glisson::test {

/// A file of a zip archive, written byte by byte.
struct ZipFile {
  std::string name, content;
  bool deflated = false, zip64 = false, encrypted = false;
  std::uint16_t other_method = 0;  ///< claimed instead of the one that it is packed by
  std::uint64_t claimed_size = 0;  ///< claimed instead of the content's
  std::uint32_t unix_mode = 0;     ///< of the file, as Unix writes it: 0120777 is a link
};

inline std::string zip_of(const std::vector<ZipFile>& files) {
  const auto put = [](std::string& bytes, std::uint64_t value, int size) {
    for (int n = 0; n < size; ++n) bytes.push_back(static_cast<char>(value >> (8 * n) & 0xFFU));
  };
  std::string bytes, directory;
  for (const ZipFile& file : files) {
    const std::string packed = file.deflated ? deflated(file.content) : file.content;
    const std::uint64_t size = file.claimed_size > 0 ? file.claimed_size : file.content.size();
    const std::uint16_t method = file.other_method > 0 ? file.other_method : file.deflated ? 8 : 0;
    const std::uint64_t at = bytes.size();
    const bool wide = file.zip64 || size > 0xFFFFFFFFULL;
    std::string extra;
    if (wide) {
      put(extra, 1, 2);
      put(extra, 16, 2);
      put(extra, size, 8);
      put(extra, packed.size(), 8);
    }
    const auto common = [&](std::string& to) {  // from "version needed" on
      put(to, wide ? 45 : 20, 2);
      put(to, file.encrypted ? 1 : 0, 2);
      put(to, method, 2);
      put(to, 0, 4);  // time
      put(to, crc_of(file.content), 4);
      put(to, wide ? 0xFFFFFFFFULL : packed.size(), 4);
      put(to, wide ? 0xFFFFFFFFULL : size, 4);
      put(to, file.name.size(), 2);
      put(to, extra.size(), 2);
    };
    bytes += std::string("PK\3\4", 4);
    common(bytes);
    bytes += file.name + extra + packed;
    directory += std::string("PK\1\2", 4);
    put(directory, file.unix_mode != 0 ? 3U << 8U | 20U : 20U, 2);
    common(directory);
    put(directory, 0, 2 + 2 + 2);  // comment, disk, internal
    put(directory, static_cast<std::uint64_t>(file.unix_mode) << 16U, 4);
    put(directory, at, 4);
    directory += file.name + extra;
  }
  const std::uint64_t at = bytes.size();
  bytes += directory + std::string("PK\5\6", 4);
  put(bytes, 0, 4);
  put(bytes, files.size(), 2);
  put(bytes, files.size(), 2);
  put(bytes, directory.size(), 4);
  put(bytes, at, 4);
  put(bytes, 0, 2);
  return bytes;
}

}  // namespace glisson::test
