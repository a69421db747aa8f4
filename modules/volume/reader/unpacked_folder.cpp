// SPDX-License-Identifier: GPL-3.0-or-later
#include "unpacked_folder.h"

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iterator>

#include "glisson/core/error.h"

namespace glisson::reader {
namespace {

namespace fs = std::filesystem;

constexpr int kMostFiles = 100000;
constexpr int kMostFolders = 5000;  // to make and remove them takes longest
constexpr int kDeepest = 32;        // folders in folders
constexpr double kMostRatio = 100.0, kAlwaysAllowed = 256e6, kStaysFree = 1e9;

/// Below the folder whatever it is called; empty: nothing is left of it.
fs::path kept_path(const std::string& name) {
  fs::path kept;
  for (const fs::path& part : fs::path(name).relative_path()) {
    if (part == "..") return {};
    if (part != "." && !part.empty()) kept /= part;
  }
  return kept;
}

}  // namespace

void refuse_damaged(const Request& request) {
  refuse(request, "", "cannot be unpacked: it is damaged",
         "Fetch the archive again, or unpack it yourself and name the folder");
}

UnpackedFolder::UnpackedFolder(const Request& request, fs::path folder)
    : request_(request), folder_(std::move(folder)) {
  struct statvfs disk {};
  if (::statvfs(folder_.c_str(), &disk) == 0)
    free_ = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize) - kStaysFree;
}

void UnpackedFolder::make_folders(const fs::path& name) {
  if (std::distance(name.begin(), name.end()) > kDeepest + 1)
    refuse(request_, "", "holds folders in folders more than 32 deep, which no series has",
           "Unpack it yourself and name the folder of the series");
  fs::path above;
  for (const fs::path& part : name.parent_path()) {
    above /= part;
    if (!folders_.insert(above.string()).second) continue;
    if (folders_.size() > kMostFolders)
      refuse(request_, "", "holds more than 5000 folders, which no series has",
             "Unpack it yourself and name the folder of the series");
    std::error_code failure;
    fs::create_directory(folder_ / above, failure);
  }
}

int UnpackedFolder::make(const std::string& name) {
  const fs::path kept = kept_path(name);
  if (kept.empty()) return -1;
  if (++files_ > kMostFiles)
    refuse(request_, "", "holds more than 100000 files, which no series has",
           "Unpack it yourself and name the folder of the series");
  make_folders(kept);
  const int file =
      ::open((folder_ / kept).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0600);
  if (file < 0)
    throw FileError((folder_ / kept).string() + ": could not be made (" + std::strerror(errno) +
                    "). Free space for temporary files.");
  return file;
}

void UnpackedFolder::write(int file, const char* bytes, std::size_t size) const {
  if (file >= 0 && ::write(file, bytes, size) != static_cast<ssize_t>(size))
    throw FileError(folder_.string() + ": could not be written. Free space for temporary files.");
}

void UnpackedFolder::spend(double bytes, double packed) {
  total_ += bytes;
  if (total_ > kAlwaysAllowed + kMostRatio * packed)
    refuse(request_, "", "unpacks to more than a hundred times its size, which no images do",
           "Ask where it comes from; unpack it yourself and name the folder if it is good");
  if (total_ > free_)
    refuse(request_, "",
           "needs more space for temporary files than is free in " + folder_.parent_path().string(),
           "Free some space, set TMPDIR to a larger disk, or unpack it yourself and name the folder");
}

OpenFile::~OpenFile() {
  if (file_ >= 0) ::close(file_);
}

}  // namespace glisson::reader
