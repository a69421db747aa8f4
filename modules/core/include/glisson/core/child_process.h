// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"

/// @file
/// Programs of our own that parse foreign files for us: what a file does to them it does to them alone. Each
/// is in a process group of its own: what asks Glisson's group to stop (Ctrl-C, `timeout`) does not end them
/// behind its back.

namespace glisson {

/// Where a helper program is: named by an environment variable, beside the running program, or in ../bin.
/// @throws FileError it is missing.
std::filesystem::path helper_program(const std::string& name, const char* variable);

/// How a child process ended.
struct ChildExit {
  int code = -1;   ///< its exit code; -1 when a signal ended it
  int signal = 0;  ///< the signal that ended it, or 0
};

/// Runs a program with its arguments and waits. Nothing is read from standard input, standard error is
/// dropped, each line of standard output goes to `on_line`. Safe with threads around (posix_spawn).
/// A child that says nothing for ten minutes is killed, and one that has run for `most_seconds`, whatever it
/// says.
/// @return empty when the context was cancelled: the child is killed and reaped then.
/// @throws FileError when the program cannot be started.
Cancellable<ChildExit> run_child(const std::string& program, const std::vector<std::string>& arguments,
                                 const RunContext& context,
                                 const std::function<void(const std::string&)>& on_line,
                                 double most_seconds = 3600.0);

/// A child that is asked and answers, through one socket that is its standard input and output. It is killed
/// and reaped with this object; when this process dies, its input ends. Not for two threads at once.
class Conversation {
 public:
  /// @throws FileError when the program cannot be started.
  Conversation(const std::string& program, const std::vector<std::string>& arguments);
  ~Conversation();
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  /// All the bytes, or false: the child has ended, or took longer than `seconds`. It is killed then, and
  /// whatever is asked of it later fails, too.
  bool send(const void* bytes, std::size_t count, double seconds);
  bool receive(void* bytes, std::size_t count, double seconds);
  /// Whether there is something to receive, or the child has ended; waits so long for it at the most. What
  /// may take long can be cancelled between two of these.
  bool waits_for(double seconds) const;
  /// A value of bytes alone.
  template <class T>
  bool send(const T& value, double seconds) {
    return send(&value, sizeof value, seconds);
  }
  template <class T>
  bool receive(T& value, double seconds) {
    return receive(&value, sizeof value, seconds);
  }
  /// Kills the child: what it says is not believed any more.
  void end();

 private:
  bool exchange(bool sends, char* bytes, std::size_t count, double seconds);

  int child_ = -1, socket_ = -1;
};

}  // namespace glisson
