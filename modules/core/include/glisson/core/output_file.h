// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "glisson/core/claim.h"

namespace glisson {

/// Where a file that is written to `path` really goes: the end of the links, so that a link stays one.
/// @throws FileError a link that leads back to itself, or that another user has put into a folder open to
/// all.
std::filesystem::path end_of_links(const std::filesystem::path& path);

/// The same for a file: what is there already is one. @throws FileError also a folder, a device, a pipe, or a
/// folder around it that is not there.
std::filesystem::path place_for_file(const std::filesystem::path& path);

/// A file on its way: written beside where it is to stand, under a name that nobody can foresee, held as long
/// as it is being written, and moved there by commit(). Without it nothing remains.
class OutputFile {
 public:
  /// @throws FileError see place_for_file, and when no file can be made there.
  explicit OutputFile(const std::filesystem::path& wanted);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Where it is now: in the same folder and with the same extension, by which many writers choose their
  /// format.
  const std::filesystem::path& path() const { return path_; }
  /// @throws FileError.
  void write(const std::string& content) const;
  /// Flushed to the disk, then in place of what was there, with its permissions. @throws FileError.
  void commit();

 private:
  std::filesystem::path wanted_, place_, path_;
  Claim claim_;
};

}  // namespace glisson
