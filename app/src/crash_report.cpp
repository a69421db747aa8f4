// SPDX-License-Identifier: GPL-3.0-or-later
#include "crash_report.h"
#include "glisson/core/time_text.h"

#include <execinfo.h>
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>
#include <vector>

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kKept = 10, kFrames = 64;
constexpr std::array<int, 5> kSignals = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL};

// A handler may touch nothing that allocates: all that it needs is made before.
std::array<char, 4096> report_path{}, report_head{};
alignas(16) std::array<char, 65536> own_stack{};  // the program's may be what ran out

void put(int file, const char* text) { (void)!::write(file, text, std::strlen(text)); }

/// Of a signal's number, without what a handler may not call.
const char* name_of(int signal) {
  return signal == SIGSEGV   ? "SIGSEGV"
         : signal == SIGABRT ? "SIGABRT"
         : signal == SIGBUS  ? "SIGBUS"
         : signal == SIGFPE  ? "SIGFPE"
                             : "SIGILL";
}

void on_crash(int signal) {
  const int file = ::open(report_path.data(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
  if (file >= 0) {
    put(file, report_head.data());
    put(file, "signal ");
    put(file, name_of(signal));
    put(file, "\n\n");
    std::array<void*, kFrames> frames{};
    const int depth = ::backtrace(frames.data(), static_cast<int>(frames.size()));
    ::backtrace_symbols_fd(frames.data(), depth, file);
    ::close(file);
    put(STDERR_FILENO, "glisson: ended unexpectedly (");
    put(STDERR_FILENO, name_of(signal));
    put(STDERR_FILENO, "). A report that stays on this machine: ");
    put(STDERR_FILENO, report_path.data());
    put(STDERR_FILENO, "\n");
  }
  // The handler is gone (SA_RESETHAND): the process ends as it would have ended.
  ::raise(signal);
}

void remove_old(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> reports;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".txt") reports.push_back(entry.path());
  std::sort(reports.begin(), reports.end());  // by time, which their names begin with
  for (std::size_t n = 0; n + kKept < reports.size() + 1; ++n) fs::remove(reports[n], ignored);
}

}  // namespace

void report_crashes(const fs::path& folder, const char* doing) {
  std::error_code failure;
  if (folder.empty()) return;
  fs::create_directories(folder, failure);
  if (!failure) fs::permissions(folder, fs::perms::owner_all, failure);
  if (failure) return;
  remove_old(folder);
  const std::string time = utc_time_text("%Y%m%dT%H%M%SZ");
  const fs::path file = folder / (time + "-" + std::to_string(::getpid()) + ".txt");
  if (file.string().size() >= report_path.size()) return;
  std::snprintf(report_path.data(), report_path.size(), "%s", file.c_str());
  std::snprintf(report_head.data(), report_head.size(), "glisson %s\nstarted %s\ndoing %s\n", GLISSON_VERSION,
                time.c_str(), *doing == '\0' ? "window" : doing);
  std::array<void*, 2> first{};
  ::backtrace(first.data(), 2);  // loads what it needs now, not inside the handler
  stack_t stack = {};
  stack.ss_sp = own_stack.data();
  stack.ss_size = own_stack.size();
  ::sigaltstack(&stack, nullptr);
  struct sigaction action = {};
  action.sa_handler = on_crash;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK | SA_NODEFER);
  for (const int signal : kSignals) ::sigaction(signal, &action, nullptr);
}

}  // namespace glisson::app
