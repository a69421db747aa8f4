// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace glisson {

/// ASCII letters in lower case; the rest as it is, whatever the locale.
std::string lower_case(std::string text);
/// A file's name and its extension (with the dot) in lower case: "CT.NII.GZ" is the file "ct.nii.gz" is.
std::string lower_name(const std::filesystem::path& path);
std::string lower_extension(const std::filesystem::path& path);

/// Reads a whole file. @throws FileError naming the path when it is missing or unreadable.
std::string read_file(const std::filesystem::path& path);

/// Writes a file so that, whatever happens (kill, full disk), the path holds the old content or all of the
/// new: writes beside it, flushes to disk, reads back and compares, then renames. @throws FileError; nothing
/// is left behind then.
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

/// A new folder that goes away with the object. For work in progress and for tests.
class TemporaryFolder {
 public:
  /// @param beside the folder in which to make it; empty: the system's.
  explicit TemporaryFolder(const std::filesystem::path& beside = {});
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace glisson
