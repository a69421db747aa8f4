// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "glisson/core/claim.h"

namespace glisson::engine {

/// Who has a case open for writing.
struct CaseOwner {
  std::string user, host;
  long process = 0;
  std::string boot;      ///< of the machine; a lock from before its last start is stale
  std::string since;     ///< local time, "2026-11-22 06:42"
  bool is_there = true;  ///< false: nobody has it, but no lock can be written there

  /// "anna on lap-or2 (process 4711, since 2026-11-22 06:42)", or that nobody says who.
  std::string told() const;
};

/// Holds a case for writing, for all programs that ask, as long as it lives. A file beside the case
/// (.NAME.glisson.lock) says who; it is held by the kernel (flock), which lets go when the process ends,
/// however it ends. A lock of this machine that nobody holds is stale. One of another machine is believed:
/// where the file system does not carry locks from one machine to the other, nobody can tell here.
class CaseLock {
 public:
  /// @param folder of the case, which need not be there yet.
  /// @param owner set when it is not to be had: who has it; without a name where that is not said, as by a
  /// file in the lock's place that is none.
  /// @return null: it is not to be had.
  static std::shared_ptr<const CaseLock> take(const std::filesystem::path& folder,
                                              std::optional<CaseOwner>& owner);
  ~CaseLock();
  CaseLock(const CaseLock&) = delete;
  CaseLock& operator=(const CaseLock&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  /// Whether it still keeps others out: not any more when its file was removed.
  bool holds() const { return claim_.is_at(file_); }

 private:
  CaseLock(std::filesystem::path folder, std::filesystem::path file, Claim claim);

  std::filesystem::path folder_, file_;
  Claim claim_;
};

/// The folder that a case's path stands for: absolute, at the end of its links. @throws FileError a link that
/// leads back to itself.
std::filesystem::path case_place(const std::filesystem::path& path);
std::filesystem::path lock_file_of(const std::filesystem::path& folder);

}  // namespace glisson::engine
