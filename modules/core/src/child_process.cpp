// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "glisson/core/error.h"
#include "installed.h"

extern char** environ;

namespace glisson {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kPollMilliseconds = 20;      // how long a cancel may go unnoticed
constexpr double kLongestSilence = 600.0;  // seconds

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

/// @param input becomes standard input; -1: there is none.
pid_t spawn(const std::string& program, const std::vector<std::string>& arguments, int input, int output) {
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (input >= 0)
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  else
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // Signals that this thread blocks would stay blocked in the child.
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  // A group of its own: Ctrl-C and `timeout` signal a whole group, and a child that they ended would be taken
  // for one that a damaged file has broken. This process alone is asked to stop, and stops the child.
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
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

/// A child that is killed and reaped unless its end has been waited for: whoever hears its lines may throw.
class Child {
 public:
  explicit Child(pid_t number) : number_(number) {}
  ~Child() { (void)killed(); }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ChildExit killed() {
    if (number_ >= 0) ::kill(number_, SIGKILL);
    return ended();
  }
  ChildExit ended() { return number_ < 0 ? ChildExit() : wait_for(std::exchange(number_, -1)); }

 private:
  pid_t number_;
};

/// A time to wait that is used up while this process runs. While it is stopped (Ctrl-Z), it hears nothing of
/// the child, which is no silence.
class Patience {
 public:
  /// @param silence until something is heard. @param all whatever is heard.
  Patience(double silence, double all) : silence_(silence), left_(silence), all_left_(all) {}
  explicit Patience(double seconds) : Patience(seconds, seconds) {}
  void heard() { left_ = silence_; }
  /// Waits until something can be done, for a part of what is left. @return as poll().
  int wait(pollfd& waiting) {
    const auto begin = Clock::now();
    const double turn = std::clamp(std::min(left_, all_left_), 0.0, kTurn);
    const int ready = ::poll(&waiting, 1, static_cast<int>(std::ceil(1e3 * turn)));
    const double passed = std::chrono::duration<double>(Clock::now() - begin).count();
    const double counted = std::min(passed, 2.0 * kTurn);
    left_ -= counted;
    all_left_ -= counted;
    return ready;
  }
  bool over() const { return left_ <= 0.0 || all_left_ <= 0.0; }

 private:
  static constexpr double kTurn = 1e-3 * kPollMilliseconds;
  double silence_, left_, all_left_;
};

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

fs::path helper_program(const std::string& name, const char* variable) {
  std::vector<fs::path> places;
  if (const char* named = std::getenv(variable)) places.emplace_back(named);
  std::error_code failure;
  if (const auto folder = program_folder()) {
    places.push_back(*folder / name);
    places.push_back(folder->parent_path() / "bin" / name);
  }
  for (const fs::path& place : places)
    if (::access(place.c_str(), X_OK) == 0 && fs::is_regular_file(place, failure)) return place;
  throw FileError((places.empty() ? fs::path(name) : places.front()).string() +
                  ": the program that reads foreign files is missing. Install Glisson again.");
}

Cancellable<ChildExit> run_child(const std::string& program, const std::vector<std::string>& arguments,
                                 const RunContext& context,
                                 const std::function<void(const std::string&)>& on_line,
                                 double most_seconds) {
  if (context.cancelled()) return std::nullopt;
  Pipe pipe;
  Child child(spawn(program, arguments, -1, pipe.write_end));
  pipe.close_write_end();
  std::string pending;
  std::array<char, 4096> buffer{};
  Patience patience(kLongestSilence, most_seconds);
  while (true) {
    const bool too_long = patience.over();
    if (too_long || context.cancelled()) {
      const ChildExit end = child.killed();
      if (too_long) return end;
      return std::nullopt;
    }
    pollfd waiting{pipe.read_end, POLLIN, 0};
    if (patience.wait(waiting) <= 0) continue;  // time to look at the context, or a signal of ours
    const ssize_t got = ::read(pipe.read_end, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;  // the child has closed its output: it is ending
    patience.heard();
    pending.append(buffer.data(), static_cast<std::size_t>(got));
    give_lines(pending, on_line);
  }
  return child.ended();
}

Conversation::Conversation(const std::string& program, const std::vector<std::string>& arguments) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw FileError(std::string("no socket to a helper process can be made (") + std::strerror(errno) + ").");
  socket_ = ends[0];
  try {
    child_ = spawn(program, arguments, ends[1], ends[1]);
  } catch (...) {
    ::close(ends[0]);
    ::close(ends[1]);
    throw;
  }
  ::close(ends[1]);
}

Conversation::~Conversation() { end(); }

void Conversation::end() {
  if (socket_ >= 0) ::close(socket_);
  if (child_ >= 0) {
    ::kill(child_, SIGKILL);
    wait_for(child_);
  }
  socket_ = child_ = -1;
}

bool Conversation::waits_for(double seconds) const {
  if (socket_ < 0) return true;
  pollfd waiting{socket_, POLLIN, 0};
  return ::poll(&waiting, 1, static_cast<int>(1e3 * seconds)) > 0;
}

bool Conversation::exchange(bool sends, char* bytes, std::size_t count, double seconds) {
  Patience patience(seconds);
  while (count > 0 && socket_ >= 0) {
    pollfd waiting{socket_, static_cast<short>(sends ? POLLOUT : POLLIN), 0};
    const int ready = patience.wait(waiting);
    if (ready <= 0 && !patience.over()) continue;
    ssize_t moved = -1;
    if (ready > 0)  // a child that has ended must not end us by SIGPIPE
      moved = sends ? ::send(socket_, bytes, count, MSG_NOSIGNAL | MSG_DONTWAIT)
                    : ::recv(socket_, bytes, count, MSG_DONTWAIT);
    if (ready > 0 && moved < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (moved <= 0) {
      end();
      return false;
    }
    bytes += moved;
    count -= static_cast<std::size_t>(moved);
  }
  return count == 0 && socket_ >= 0;
}

bool Conversation::send(const void* bytes, std::size_t count, double seconds) {
  return exchange(true, static_cast<char*>(const_cast<void*>(bytes)), count, seconds);
}
bool Conversation::receive(void* bytes, std::size_t count, double seconds) {
  return exchange(false, static_cast<char*>(bytes), count, seconds);
}

}  // namespace glisson
