// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "raw_volume.h"

namespace glisson::reader {

/// What a zip archive's central directory says of one of its files (PKWARE APPNOTE 6.3, 4.3.12 and 4.5.3).
struct ZipEntry {
  std::string name;                                ///< with "/" between folders
  std::uint64_t packed = 0, size = 0, header = 0;  ///< bytes; where its local header lies
  std::uint32_t crc = 0;
  unsigned method = 0, flags = 0;
  bool is_file = true;  ///< neither a folder nor, as Unix writes it, a link or a device
};

/// The bytes of an archive, at any place.
class ZipBytes {
 public:
  /// @throws FileError.
  explicit ZipBytes(const Request& request);
  std::uint64_t size() const { return size_; }
  /// @throws InputError damaged: there are not so many there.
  std::string at(std::uint64_t place, std::uint64_t count);

 private:
  const Request& request_;
  std::ifstream stream_;
  std::uint64_t size_ = 0;
};

/// Little endian. @pre the bytes are there.
std::uint64_t zip_number(const std::string& bytes, std::size_t at, int size);

/// All files, in the order of the directory.
/// @throws InputError damaged; of several parts; its files are said to hold more than the archive does.
std::vector<ZipEntry> zip_directory(const Request& request, ZipBytes& bytes);

}  // namespace glisson::reader
