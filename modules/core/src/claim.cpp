// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/claim.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>
#include "remove_tree.h"
#include "take_soon.h"

namespace glisson {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPrefix = ".glisson-";
constexpr std::size_t kDigits = 16;
constexpr int kTrials = 100;
constexpr std::chrono::seconds kLongestSweep{2};
/// What was filmed cannot be made again, and is readable as far as it came.
constexpr const char* kRecording = ".mkv";

/// A name that nobody can foresee.
std::string unforeseen_name(const std::string& ending) {
  std::uint64_t number = 0;
  while (::getrandom(&number, sizeof number, 0) != static_cast<ssize_t>(sizeof number)) continue;
  std::string name(kPrefix);
  for (std::size_t digit = 0; digit < kDigits; ++digit, number >>= 4U)
    name += "0123456789abcdef"[number & 15U];
  return name + ending;
}

bool is_work_in_progress(const std::string& name) {
  const std::size_t end = kPrefix.size() + kDigits;
  return name.starts_with(kPrefix) && name.size() >= end && (name.size() == end || name[end] == '.') &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(kPrefix.size()),
                     name.begin() + static_cast<std::ptrdiff_t>(end),
                     [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

/// ".glisson-0123456789abcdef.mkv" becomes "recovered-0123456789abcdef.mkv".
fs::path recovered_name(const fs::path& path) {
  return path.parent_path() / ("recovered-" + path.filename().string().substr(kPrefix.size()));
}

/// Makes things until one is held: somebody who sweeps may take hold of a new one first.
template <class Make>
fs::path make_held(Claim& claim, const Make& make) {
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto [path, descriptor] = make();
    if (descriptor < 0 && errno == EEXIST) continue;
    if (descriptor < 0) return {};
    claim = Claim(descriptor);
    const bool taken = claim.take() || errno != EWOULDBLOCK;
    if (taken && claim.is_at(path)) return path;
  }
  errno = EEXIST;
  return {};
}

}  // namespace

Claim& Claim::operator=(Claim&& other) noexcept {
  if (this != &other) {
    release();
    std::swap(descriptor_, other.descriptor_);
  }
  return *this;
}

fs::path Claim::make_file(const fs::path& folder, const std::string& ending, Claim& claim) {
  return make_held(claim, [&] {
    const fs::path path = folder / unforeseen_name(ending);
    return std::pair(path, ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
  });
}

fs::path Claim::make_folder(const fs::path& folder, Claim& claim) {
  return make_held(claim, [&] {
    const fs::path path = folder / unforeseen_name({});
    const bool made = ::mkdir(path.c_str(), 0700) == 0;
    return std::pair(path, made ? ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC) : -1);
  });
}

bool Claim::take() const { return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0; }

bool Claim::is_at(const fs::path& path) const {
  struct stat held = {}, there = {};
  return ::fstat(descriptor_, &held) == 0 && ::lstat(path.c_str(), &there) == 0 &&
         held.st_ino == there.st_ino && held.st_dev == there.st_dev;
}

void Claim::release() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

int sweep_leftovers(const fs::path& folder) {
  std::error_code failure;
  std::vector<fs::path> found;
  for (auto entry = fs::directory_iterator(folder, failure); !failure && entry != fs::directory_iterator();
       entry.increment(failure))
    if (is_work_in_progress(entry->path().filename().string())) found.push_back(entry->path());
  int removed = 0, waits = 10;  // of all together
  // Every start sweeps: what takes longer goes on at the next.
  const auto end = std::chrono::steady_clock::now() + kLongestSweep;
  const auto in_time = [end] { return std::chrono::steady_clock::now() < end; };
  const auto pause = [] { std::this_thread::sleep_for(std::chrono::milliseconds(10)); };
  for (const fs::path& path : found) {
    const Claim claim(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat held = {};
    if (claim.descriptor() < 0 || ::fstat(claim.descriptor(), &held) != 0) continue;
    const bool ours = held.st_uid == ::geteuid() && (S_ISREG(held.st_mode) || S_ISDIR(held.st_mode));
    if (!ours || !take_soon(claim, waits, pause) || !claim.is_at(path)) continue;
    if (S_ISREG(held.st_mode) && held.st_size > 0 && path.extension() == kRecording) {
      fs::rename(path, recovered_name(path), failure);
      removed += !failure;
    } else {
      removed += remove_tree(AT_FDCWD, path.c_str(), in_time);
    }
  }
  return removed;
}

}  // namespace glisson
