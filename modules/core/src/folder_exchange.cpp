// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/folder_exchange.h"

#include <fcntl.h>
#include <linux/fs.h>
#include <stdio.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <system_error>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/output_file.h"

namespace glisson {
namespace fs = std::filesystem;

fs::path place_for_folder(const fs::path& path) {
  fs::path place = fs::absolute(path).lexically_normal();
  if (!place.has_filename()) place = place.parent_path();
  place = end_of_links(place);
  std::error_code ignored;
  const fs::path folder = fs::canonical(place.parent_path(), ignored);
  return ignored ? place : folder / place.filename();
}

fs::path former_name(const fs::path& folder) {
  return folder.parent_path() / ("." + folder.filename().string() + ".former");
}

fs::path standing_folder(const fs::path& folder, const char* mark) {
  std::error_code ignored;
  if (fs::exists(folder, ignored)) return folder;
  const fs::path former = former_name(folder);
  return fs::exists(former / mark, ignored) ? former : folder;
}

void drop_former(const fs::path& folder, const char* mark) {
  std::error_code ignored;
  const fs::path former = former_name(folder);
  if (fs::exists(folder / mark, ignored) && fs::exists(former / mark, ignored))
    fs::remove_all(former, ignored);
}

void exchange_folders(const fs::path& fresh, const fs::path& folder, const char* mark) {
  std::error_code failure;
  if (!fs::exists(folder)) {
    fs::rename(fresh, folder, failure);
  } else if (::syscall(SYS_renameat2, AT_FDCWD, fresh.c_str(), AT_FDCWD, folder.c_str(), RENAME_EXCHANGE) ==
             0) {
    fs::remove_all(fresh, failure);  // the former one, now under the temporary name
    failure.clear();
  } else {
    drop_former(folder, mark);
    const fs::path former = former_name(folder);
    fs::rename(folder, former, failure);
    if (!failure) {
      fs::rename(fresh, folder, failure);
      std::error_code ignored;
      if (failure)
        fs::rename(former, folder, ignored);
      else
        fs::remove_all(former, failure);
    }
  }
  if (failure) throw FileError(folder.string() + ": could not be replaced (" + failure.message() + ").");
  drop_former(folder, mark);
  flush_to_disk(folder.parent_path());
}

}  // namespace glisson
