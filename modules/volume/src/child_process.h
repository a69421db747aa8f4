// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"

namespace glisson {

/// How a child process ended.
struct ChildExit {
  int code = -1;   ///< its exit code; -1 when a signal ended it
  int signal = 0;  ///< the signal that ended it, or 0
};

/// Runs a program with its arguments and waits. Nothing is read from standard input, standard error is
/// dropped, each line of standard output goes to `on_line`. Safe with threads around (posix_spawn).
/// A child that says nothing for ten minutes is killed.
/// @return empty when the context was cancelled: the child is killed and reaped then.
/// @throws FileError when the program cannot be started.
Cancellable<ChildExit> run_child(const std::string& program, const std::vector<std::string>& arguments,
                                 const RunContext& context,
                                 const std::function<void(const std::string&)>& on_line);

}  // namespace glisson
