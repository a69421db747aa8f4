// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/output_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "glisson/core/error.h"
#include "glisson/core/files.h"

namespace glisson {
namespace fs = std::filesystem;
namespace {

constexpr int kMostLinks = 40;  // as the kernel follows

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// As the kernel's protected_symlinks: in a folder that is open to all, others may plant links.
bool is_planted(const fs::path& link, const struct stat& itself) {
  struct stat around = {};
  if (::stat(folder_of(link).c_str(), &around) != 0) return false;
  const bool open_to_all = (around.st_mode & S_IWOTH) != 0;
  return open_to_all && itself.st_uid != ::geteuid() && itself.st_uid != around.st_uid;
}

}  // namespace

fs::path end_of_links(const fs::path& path) {
  fs::path at = path;
  for (int link = 0; link < kMostLinks; ++link) {
    struct stat found = {};
    if (::lstat(at.c_str(), &found) != 0) {
      if (errno == ELOOP) break;
      return at;
    }
    if (!S_ISLNK(found.st_mode)) return at;
    if (is_planted(at, found))
      throw FileError(path.string() +
                      ": is a link that another user has put there. Choose another name or folder.");
    std::error_code failure;
    const fs::path target = fs::read_symlink(at, failure);
    if (failure) return at;
    at = target.is_absolute() ? target : at.parent_path() / target;
  }
  throw FileError(path.string() + ": is a link that leads back to itself. Choose another name.");
}

fs::path place_for_file(const fs::path& path) {
  const fs::path place = end_of_links(path);
  std::error_code failure;
  const fs::file_status there = fs::status(place, failure);
  if (fs::is_directory(there))
    throw FileError(path.string() + ": is a folder, a file is to be written here. Choose another name.");
  if (fs::exists(there) && !fs::is_regular_file(there))
    throw FileError(path.string() + ": is a device or a pipe, not a file. Choose another name.");
  if (!fs::is_directory(folder_of(place), failure))
    throw FileError(path.string() + ": its folder does not exist. Create it or choose another.");
  return place;
}

OutputFile::OutputFile(const fs::path& wanted) : wanted_(wanted), place_(place_for_file(wanted)) {
  path_ = Claim::make_file(folder_of(place_), place_.extension().string(), claim_);
  if (path_.empty())
    throw FileError(wanted_.string() + ": could not be written (" + std::strerror(errno) +
                    "). Check permissions and free space.");
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove(path_, ignored);
}

void OutputFile::write(const std::string& content) const {
  const char* at = content.data();
  for (std::size_t left = content.size(); left > 0;) {
    const ssize_t written = ::write(claim_.descriptor(), at, left);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0)
      throw FileError(wanted_.string() + ": could not be written (" + std::strerror(errno) +
                      "). Check permissions and free space.");
    at += written;
    left -= static_cast<std::size_t>(written);
  }
}

void OutputFile::commit() {
  if (!claim_.is_at(path_))
    throw FileError(wanted_.string() + ": was replaced while it was written. Write it again.");
  struct stat before = {};
  if (::stat(place_.c_str(), &before) == 0 && ::fchmod(claim_.descriptor(), before.st_mode & 0777U) != 0)
    throw FileError(wanted_.string() + ": its permissions could not be kept (" + std::strerror(errno) +
                    "). Choose another name.");
  flush_to_disk(path_);
  std::error_code failure;
  fs::rename(path_, place_, failure);
  if (failure)
    throw FileError(wanted_.string() + ": could not be replaced (" + failure.message() +
                    "). Choose another name.");
  path_.clear();
  flush_to_disk(folder_of(place_));
}

}  // namespace glisson
