// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_reach.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

#include "case_manifest.h"
#include "glisson/core/error.h"
#include "glisson/core/failure_sentence.h"
#include "glisson/engine/part.h"

namespace glisson::engine {
namespace fs = std::filesystem;
namespace {

bool is_below(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

void require_own(const fs::path& path, const fs::path& root) {
  std::error_code failure;
  const fs::file_status status = fs::symlink_status(path, failure);
  if (fs::is_symlink(status)) {
    const fs::path target = fs::canonical(path, failure);
    if (failure || !is_below(target, root))
      throw InputError(path.string(), "", "is a link that leads out of the case, or to nothing",
                       "Put a copy of what it means in its place, or remove it");
  } else if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) {
    throw InputError(path.string(), "", "is neither a file nor a folder", "Remove it from the case");
  }
}

/// The same of a folder with all that is in it.
void require_all_own(const fs::path& path, const fs::path& root, std::error_code& failure) {
  std::error_code absent;
  require_own(path, root);
  if (!fs::is_directory(path, absent)) return;
  fs::recursive_directory_iterator entry(path, failure);
  for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure))
    require_own(entry->path(), root);
}

}  // namespace

fs::path file_of_case(const fs::path& folder, const char* field, const std::string& named) {
  const fs::path name = fs::path(named).lexically_normal();
  if (name.empty() || name.is_absolute() || *name.begin() == "..")
    throw InputError((folder / kCaseFile).string(), field,
                     "names \"" + named.substr(0, 80) + "\", which lies outside the case",
                     "Restore the case from a copy; nothing outside its folder is opened");
  return folder / name;
}

void require_own_files(const fs::path& folder) {
  std::error_code failure;
  const fs::path root = fs::canonical(folder, failure);
  // Anything else in the folder is somebody's own, and nobody opens it.
  std::set<fs::path> names = {kCaseFile};
  for (const fs::path file : files_of_parts()) names.insert(*file.begin());  // a file, or its folder
  for (const fs::path& name : names) {
    if (failure) break;
    require_all_own(root / name, root, failure);
  }
  if (failure) throw FileError(sentence_of(fs::filesystem_error("", folder, failure)));
}

bool lies_in_case(const fs::path& folder, const fs::path& place) {
  std::error_code failure;
  const fs::path root = fs::canonical(folder, failure);
  if (failure) return false;
  const fs::path real = fs::canonical(place, failure);
  if (failure || !is_below(real, root)) return false;
  try {
    require_all_own(real, root, failure);
  } catch (const InputError&) {
    return false;
  }
  return !failure;
}

}  // namespace glisson::engine
