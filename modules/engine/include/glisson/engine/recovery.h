// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/claim.h"

namespace glisson::engine {

/// Where copies for recovery lie unless somebody says otherwise: below XDG_STATE_HOME (~/.local/state), in a
/// folder that no other may enter. Empty: there is no home.
std::filesystem::path recovery_root();

/// A case as a program had it that ended without closing it.
struct Recoverable {
  std::filesystem::path folder;  ///< of that program; holds the copy
  std::filesystem::path copy;    ///< the case
  std::filesystem::path of;      ///< the case that it is a copy of; empty: it had never been saved
  std::string edition;           ///< of that case when the copy was made
  std::string saved;             ///< local time, "2026-11-22 06:42"
};

/// The copies that one program keeps of what it works on. As long as it lives, no other takes them for left
/// behind; what it leaves when it ends well is nothing.
class RecoveryFolder {
 public:
  /// @param root made when there is none yet. @throws FileError.
  explicit RecoveryFolder(const std::filesystem::path& root);
  ~RecoveryFolder();
  RecoveryFolder(const RecoveryFolder&) = delete;
  RecoveryFolder& operator=(const RecoveryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// There is nothing to be recovered any more.
  void clear() const;

 private:
  std::filesystem::path path_;
  Claim claim_;
};

/// What programs that ended otherwise have left, the newest first. What holds no whole case is removed.
std::vector<Recoverable> find_recoverable(const std::filesystem::path& root);
/// Removes a copy. One that another program has taken meanwhile stays.
void discard(const Recoverable& copy);

}  // namespace glisson::engine
