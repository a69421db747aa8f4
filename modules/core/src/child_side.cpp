// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/child_side.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <limits>

#include "glisson/core/confinement.h"

namespace glisson::child_side {
namespace {

/// @param move_some as read and write: bytes, count -> how many, or -1.
template <class Byte, class MoveSome>
bool move_all(Byte* at, std::size_t count, const MoveSome& move_some) {
  while (count > 0) {
    const ssize_t moved = move_some(at, count);
    if (moved < 0 && errno == EINTR) continue;
    if (moved <= 0) return false;
    at += moved;
    count -= static_cast<std::size_t>(moved);
  }
  return true;
}

}  // namespace

void begin() {
  ::syscall(SYS_close_range, 3U, std::numeric_limits<unsigned>::max(), 0U);
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  leave_requests_to_the_parent();
}

void allow_seconds(double seconds) {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  const auto of = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  limit_seconds(of(used.ru_utime) + of(used.ru_stime) + seconds);
}

int tell_escapes(const std::string& folder) {
  confine({}, {folder});
  std::ofstream file(folder + "/escapes");
  for (const std::string& word : escapes()) file << word << "\n";
  return 0;
}

bool hear(void* bytes, std::size_t count) {
  return move_all(static_cast<char*>(bytes), count,
                  [](char* at, std::size_t left) { return ::read(STDIN_FILENO, at, left); });
}

bool tell(const void* bytes, std::size_t count) {
  return move_all(static_cast<const char*>(bytes), count,
                  [](const char* at, std::size_t left) { return ::write(STDOUT_FILENO, at, left); });
}

}  // namespace glisson::child_side
