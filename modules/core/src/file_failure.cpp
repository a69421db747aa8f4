// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/file_failure.h"

#include <system_error>

namespace glisson {

std::string sentence_of(const std::filesystem::filesystem_error& failure) {
  const auto remedy = [&]() -> const char* {
    if (failure.code() == std::errc::too_many_symbolic_link_levels)
      return "It is a link that leads back to itself: name another";
    if (failure.code() == std::errc::permission_denied ||
        failure.code() == std::errc::operation_not_permitted)
      return "Check the permissions of the file and of its folders";
    if (failure.code() == std::errc::no_space_on_device) return "Free some space on the disk";
    if (failure.code() == std::errc::filename_too_long) return "Choose a shorter name";
    return "Check the path";
  };
  const std::string path = failure.path1().empty() ? std::string("file") : failure.path1().string();
  return path + ": cannot be used (" + failure.code().message() + "). " + remedy() + ".";
}

}  // namespace glisson
