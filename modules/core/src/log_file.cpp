// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/log_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <system_error>
#include <utility>

#include "glisson/core/claim.h"
#include "glisson/core/time_text.h"

namespace glisson {
namespace fs = std::filesystem;
namespace {

constexpr const char* kName = "glisson.log";

class LogFile {
 public:
  LogFile(fs::path folder, std::size_t bytes, int kept)
      : folder_(std::move(folder)), bytes_(bytes), kept_(kept) {}

  void write(LogLevel level, std::string_view line) {
    static constexpr std::array<const char*, 4> kLevels = {"debug", "info", "warning", "error"};
    std::string text = utc_time_text("%Y-%m-%dT%H:%M:%SZ") + ' ' + std::to_string(::getpid()) + ' ' +
                       kLevels[static_cast<std::size_t>(level)] + ' ' + std::string(line);
    std::replace(text.begin(), text.end(), '\n', ' ');
    text += '\n';
    const std::scoped_lock lock(mutex_);
    make_room();
    const int file = open_log();
    if (file < 0) return;
    (void)!::write(file, text.data(), text.size());  // one call: lines of several programs stay whole
    ::close(file);
  }

 private:
  int open_log() const {
    return ::open((folder_ / kName).c_str(), O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600);
  }
  fs::path former(int number) const { return folder_ / (std::string(kName) + "." + std::to_string(number)); }

  void make_room() const {
    std::error_code failure;
    const auto size = fs::file_size(folder_ / kName, failure);
    if (failure || size < bytes_) return;
    // Whoever else wants to do it at this moment finds it done.
    const Claim claim(open_log());
    if (claim.descriptor() < 0 || !claim.take() || !claim.is_at(folder_ / kName)) return;
    fs::remove(former(kept_), failure);
    for (int number = kept_; number > 1; --number)
      if (fs::exists(former(number - 1), failure)) fs::rename(former(number - 1), former(number), failure);
    if (kept_ > 0)
      fs::rename(folder_ / kName, former(1), failure);
    else
      fs::remove(folder_ / kName, failure);
  }

  fs::path folder_;
  std::size_t bytes_;
  int kept_;
  std::mutex mutex_;
};

}  // namespace

fs::path state_folder() {
  const auto named = [](const char* variable) {
    const char* value = std::getenv(variable);
    return fs::path(value == nullptr ? "" : value);
  };
  const fs::path state = named("XDG_STATE_HOME"), home = named("HOME");
  const fs::path root = state.is_absolute() ? state : home / ".local/state";
  return root.is_absolute() ? root / "glisson" : fs::path();
}

fs::path log_folder() { return state_folder().empty() ? fs::path() : state_folder() / "log"; }
fs::path crash_folder() { return state_folder().empty() ? fs::path() : state_folder() / "crashes"; }

Log log_to_file(const fs::path& folder, std::size_t bytes, int kept) {
  std::error_code failure;
  if (folder.empty()) return {};
  fs::create_directories(folder, failure);
  if (!failure) fs::permissions(folder, fs::perms::owner_all, failure);
  if (failure) return {};
  const auto file = std::make_shared<LogFile>(folder, bytes, kept);
  return Log([file](LogLevel level, std::string_view line) { file->write(level, line); });
}

}  // namespace glisson
