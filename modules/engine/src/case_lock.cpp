// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/case_lock.h"

#include <fcntl.h>
#include <pwd.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/core/folder_exchange.h"
#include "glisson/core/printable.h"
#include "glisson/core/time_text.h"

namespace glisson::engine {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

constexpr int kTrials = 20;

std::string first_line(const fs::path& path) {
  std::ifstream stream(path);
  std::string line;
  std::getline(stream, line);
  return line;
}

CaseOwner this_process() {
  CaseOwner owner;
  // getpwuid_r: names may come from a directory service, asked from any thread.
  std::array<char, 4096> buffer{};
  struct passwd entry = {};
  struct passwd* found = nullptr;
  if (::getpwuid_r(::geteuid(), &entry, buffer.data(), buffer.size(), &found) == 0 && found != nullptr)
    owner.user = found->pw_name;
  else
    owner.user = std::to_string(::geteuid());
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) == 0) owner.host = host.data();
  owner.process = ::getpid();
  owner.boot = first_line("/proc/sys/kernel/random/boot_id");
  owner.since = local_time_text("%Y-%m-%d %H:%M");
  return owner;
}

std::string written(const CaseOwner& owner) {
  return json{{"user", owner.user},
              {"host", owner.host},
              {"process", owner.process},
              {"boot", owner.boot},
              {"since", owner.since}}
             .dump() +
         "\n";
}

bool is_plain_file(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

/// Whether it is a lock, or empty, and no other name of another file: whatever else it is, it is not written
/// over.
bool may_be_written(int descriptor, bool says_who) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && status.st_nlink == 1 && (says_who || status.st_size == 0);
}

/// Empty: nothing is said, or nothing that makes sense.
std::optional<CaseOwner> read_owner(int descriptor) {
  std::array<char, 4096> text{};
  const ssize_t size = ::pread(descriptor, text.data(), text.size(), 0);
  if (size <= 0) return {};
  const json document = json::parse(text.data(), text.data() + size, nullptr, false);
  try {
    return CaseOwner{document.at("user"), document.at("host"), document.at("process"), document.at("boot"),
                     document.at("since")};
  } catch (const json::exception&) {
    return {};
  }
}

/// Whether the one who wrote the lock may still be at work although nobody holds the file.
/// @param kernel_knows the file system has locks, and this one is free.
bool may_be_alive(const CaseOwner& owner, const CaseOwner& here, bool kernel_knows) {
  if (owner.host != here.host) return true;
  if (kernel_knows || owner.boot != here.boot) return false;
  return ::kill(static_cast<pid_t>(owner.process), 0) == 0 || errno == EPERM;
}

bool write_owner(int descriptor, const CaseOwner& owner) {
  const std::string text = written(owner);
  return ::ftruncate(descriptor, 0) == 0 &&
         ::pwrite(descriptor, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
}

}  // namespace

std::string CaseOwner::told() const {
  if (user.empty() && host.empty()) return "somebody who does not say who";
  return printable(user + " on " + host + " (process " + std::to_string(process) + ", since " + since + ")",
                   200);
}

fs::path case_place(const fs::path& path) { return place_for_folder(path); }

fs::path lock_file_of(const fs::path& folder) {
  return folder.parent_path() / ("." + folder.filename().string() + ".lock");
}

CaseLock::CaseLock(fs::path folder, fs::path file, Claim claim)
    : folder_(std::move(folder)), file_(std::move(file)), claim_(std::move(claim)) {}

CaseLock::~CaseLock() {
  std::error_code ignored;
  if (claim_.is_at(file_)) fs::remove(file_, ignored);
}

std::shared_ptr<const CaseLock> CaseLock::take(const fs::path& folder, std::optional<CaseOwner>& owner) {
  const fs::path file = lock_file_of(folder);
  const CaseOwner here = this_process(), nobody{.is_there = false};
  for (int trial = 0; trial < kTrials; ++trial) {
    // A pipe that somebody has put there would be waited for without an end.
    constexpr int kFlags = O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK;
    int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | kFlags, 0644);
    // Another person's lock can be read, and so be seen to be held, where it cannot be written.
    const bool is_anothers = descriptor < 0 && errno == EACCES;
    if (is_anothers) descriptor = ::open(file.c_str(), O_RDONLY | kFlags);
    Claim claim(descriptor);
    owner = nobody;
    if (claim.descriptor() < 0 || !is_plain_file(claim.descriptor())) return nullptr;
    const bool held = claim.take();
    const bool kernel_knows = held || errno == EWOULDBLOCK;
    if (!claim.is_at(file)) continue;  // whoever had it has just removed it
    const auto writer = read_owner(claim.descriptor());
    owner = writer.value_or(CaseOwner{});
    if (!held && kernel_knows) return nullptr;
    if (writer && may_be_alive(*writer, here, kernel_knows)) return nullptr;
    if (!may_be_written(claim.descriptor(), writer.has_value())) return nullptr;
    owner = nobody;
    if (is_anothers) {  // left behind: in the folder, which is everybody's, it is made anew
      std::error_code failure;
      if (!fs::remove(file, failure)) return nullptr;
      continue;
    }
    if (!write_owner(claim.descriptor(), here)) return nullptr;
    owner.reset();
    return std::shared_ptr<const CaseLock>(new CaseLock(folder, file, std::move(claim)));
  }
  return nullptr;
}

}  // namespace glisson::engine
