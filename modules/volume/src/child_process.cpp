// SPDX-License-Identifier: GPL-3.0-or-later
#include "child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include "glisson/core/error.h"

extern char** environ;

namespace glisson {
namespace {

constexpr int kPollMilliseconds = 20;  // how long a cancel may go unnoticed
constexpr std::chrono::minutes kLongestSilence(10);

/// Both ends of a pipe, closed when done with.
struct Pipe {
  int read_end = -1, write_end = -1;
  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
      throw FileError(std::string("no pipe to a helper process can be made (") + std::strerror(errno) + ").");
    read_end = ends[0];
    write_end = ends[1];
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_write_end();
    ::close(read_end);
  }
  void close_write_end() {
    if (write_end >= 0) ::close(write_end);
    write_end = -1;
  }
};

pid_t spawn(const std::string& program, const std::vector<std::string>& arguments, int output) {
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  // Signals that this thread blocks would stay blocked in the child.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t child = -1;
  const int failure =
      ::posix_spawnp(&child, program.c_str(), &actions, &attributes, pointers.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0)
    throw FileError(program + ": cannot be started (" + std::strerror(failure) + "). Install Glisson again.");
  return child;
}

ChildExit wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return {};
  if (WIFSIGNALED(status)) return {-1, WTERMSIG(status)};
  return {WEXITSTATUS(status), 0};
}

/// Hands out the whole lines in `pending` and keeps the rest.
void give_lines(std::string& pending, const std::function<void(const std::string&)>& on_line) {
  std::size_t end = 0;
  while ((end = pending.find('\n')) != std::string::npos) {
    const std::string line = pending.substr(0, end);
    pending.erase(0, end + 1);
    if (on_line) on_line(line);
  }
}

}  // namespace

Cancellable<ChildExit> run_child(const std::string& program, const std::vector<std::string>& arguments,
                                 const RunContext& context,
                                 const std::function<void(const std::string&)>& on_line) {
  if (context.cancelled()) return std::nullopt;
  Pipe pipe;
  const pid_t child = spawn(program, arguments, pipe.write_end);
  pipe.close_write_end();
  std::string pending;
  std::array<char, 4096> buffer{};
  auto heard = std::chrono::steady_clock::now();
  while (true) {
    const bool silent = std::chrono::steady_clock::now() - heard > kLongestSilence;
    if (silent || context.cancelled()) {
      ::kill(child, SIGKILL);
      const ChildExit end = wait_for(child);
      if (silent) return end;
      return std::nullopt;
    }
    pollfd waiting{pipe.read_end, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, kPollMilliseconds);
    if (ready <= 0) continue;  // time to look at the context, or a signal of ours
    const ssize_t got = ::read(pipe.read_end, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;  // the child has closed its output: it is ending
    heard = std::chrono::steady_clock::now();
    pending.append(buffer.data(), static_cast<std::size_t>(got));
    give_lines(pending, on_line);
  }
  return wait_for(child);
}

}  // namespace glisson
