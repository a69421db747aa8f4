// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "glisson/core/claim.h"

namespace glisson {

/// ASCII letters in lower case; the rest as it is, whatever the locale.
std::string lower_case(std::string text);
/// A file's name and its extension (with the dot) in lower case: "CT.NII.GZ" is the file "ct.nii.gz" is.
std::string lower_name(const std::filesystem::path& path);
std::string lower_extension(const std::filesystem::path& path);

/// More than any file that is read whole.
constexpr std::size_t kMostFileBytes = 4'000'000'000;

/// Reads a whole file. @throws FileError naming the path when it is missing, unreadable, or has more bytes
/// than such a file can have; no more than a megabyte beyond them is read.
std::string read_file(const std::filesystem::path& path, std::size_t most_bytes = kMostFileBytes);

/// Writes a file so that, whatever happens (kill, full disk), the path holds the old content or all of the
/// new: writes beside it (see OutputFile), flushes to disk, reads back and compares, then renames. Links are
/// written through, devices refused. @throws FileError; nothing is left behind then.
void write_file_atomically(const std::filesystem::path& path, const std::string& content);

/// The same for writers that insist on a path of their own (VTK, ITK, OpenCV, which report success on a full
/// disk).
/// @param write is given the temporary path, in the same folder and with the same extension.
/// @param verify is given the temporary path and throws if what was written cannot be read back whole.
void write_file_atomically(const std::filesystem::path& path,
                           const std::function<void(const std::filesystem::path&)>& write,
                           const std::function<void(const std::filesystem::path&)>& verify);

/// Flushes a file or a folder's entries to disk. @throws FileError.
void flush_to_disk(const std::filesystem::path& path);

/// Where folders for work in progress are made: TMPDIR where it is set, else below the user's cache, where no
/// other may look: what is unpacked there is a patient's. The system's shared one only where there is no
/// home.
std::filesystem::path work_folder();

/// A new folder (0700) that goes away with the object. For work in progress and for tests. Killed programs
/// leave theirs; sweep_leftovers() knows them.
class TemporaryFolder {
 public:
  /// @param beside the folder in which to make it; empty: work_folder().
  explicit TemporaryFolder(const std::filesystem::path& beside = {});
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Claim claim_;
};

}  // namespace glisson
