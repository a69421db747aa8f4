// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <set>
#include <string>

#include "raw_volume.h"

/// @file
/// Where the files of an archive go, of whatever format it is: they stay in their folder, and are counted and
/// measured before the disk is full.

namespace glisson::reader {

/// @throws InputError with the remedy for an archive that is damaged.
[[noreturn]] void refuse_damaged(const Request& request);

class UnpackedFolder {
 public:
  /// @param folder exists.
  UnpackedFolder(const Request& request, std::filesystem::path folder);

  /// A new file below the folder, and the folders above it; -1: nothing may be made of such a name ("..").
  /// @throws InputError too many files or folders, too deep, FileError.
  int make(const std::string& name);
  /// Writes to a file of make(); -1: nowhere. @throws FileError
  void write(int file, const char* bytes, std::size_t size) const;
  /// Before so many bytes more are unpacked; what is passed over counts, too: it takes its time.
  /// @param packed bytes of the archive that it took so far. @throws InputError a bomb, or no space.
  void spend(double bytes, double packed);

 private:
  void make_folders(const std::filesystem::path& name);

  const Request& request_;
  std::filesystem::path folder_;
  double free_ = std::numeric_limits<double>::infinity(), total_ = 0.0;
  int files_ = 0;
  std::set<std::string> folders_;
};

/// Closes a file of UnpackedFolder::make().
class OpenFile {
 public:
  explicit OpenFile(int file) : file_(file) {}
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int number() const { return file_; }

 private:
  int file_;
};

}  // namespace glisson::reader
