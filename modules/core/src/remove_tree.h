// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string_view>

namespace glisson {

constexpr int kDeepestTree = 500;  ///< a descriptor each

/// Removes a file or a folder with all that it holds; links are removed, not followed. Asks `may_go_on`
/// before each, and leaves the rest when the answer is no. @return whether all is gone.
template <class MayGoOn>
bool remove_tree(int folder, const char* name, const MayGoOn& may_go_on, int depth = 0) {
  if (!may_go_on() || depth > kDeepestTree) return false;
  struct stat found = {};
  if (::fstatat(folder, name, &found, AT_SYMLINK_NOFOLLOW) != 0) return false;
  if (!S_ISDIR(found.st_mode)) return ::unlinkat(folder, name, 0) == 0;
  const int inner = ::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (inner < 0) return false;
  DIR* list = ::fdopendir(inner);
  if (list == nullptr) {
    ::close(inner);
    return false;
  }
  bool whole = true;
  while (const dirent* entry = ::readdir(list)) {
    const std::string_view its_name = entry->d_name;
    if (its_name == "." || its_name == "..") continue;
    whole = remove_tree(inner, entry->d_name, may_go_on, depth + 1) && whole;
    if (!may_go_on()) break;
  }
  ::closedir(list);
  return ::unlinkat(folder, name, AT_REMOVEDIR) == 0 && whole;
}

}  // namespace glisson
