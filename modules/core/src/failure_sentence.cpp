// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/failure_sentence.h"

#include <new>
#include <system_error>

#include "glisson/core/error.h"

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

std::string sentence_of(const std::exception& failure, const std::string& work) {
  if (dynamic_cast<const Error*>(&failure) != nullptr) return failure.what();
  if (const auto* of_files = dynamic_cast<const std::filesystem::filesystem_error*>(&failure))
    return sentence_of(*of_files);
  if (dynamic_cast<const std::bad_alloc*>(&failure) != nullptr)
    return work + ": memory ran out. Close other programs, or take a smaller volume or a coarser mesh.";
  return work + ": stopped unexpectedly (" + failure.what() + "). The case is as it was.";
}

}  // namespace glisson
