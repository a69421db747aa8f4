// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <stdexcept>
#include <string_view>

#include "glisson/core/run_context.h"

namespace glisson::test {

/// Works in a child that is killed when its progress has been told the n-th time. @return whether it came
/// through before that. @throws std::runtime_error it ended in any other way.
inline bool comes_through(int moment, const std::function<void(const RunContext&)>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    int told = 0;
    const RunContext context(
        [&](double, std::string_view) {
          if (++told == moment) ::kill(::getpid(), SIGKILL);
        },
        nullptr, 1);
    try {
      work(context);
    } catch (...) {
      ::_exit(3);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return true;
  if (!WIFSIGNALED(status)) throw std::runtime_error("the child failed instead of being killed");
  return false;
}

}  // namespace glisson::test
