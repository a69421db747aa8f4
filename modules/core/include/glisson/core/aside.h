// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <thread>

#include "glisson/core/run_context.h"

namespace glisson {

/// Calls that nobody can interrupt and that may wait for long, as for a driver of a dead camera: on a thread
/// of their own, so that whoever has asked for one can go on without it. From one thread.
class Aside {
 public:
  Aside();
  /// Waits for nothing: a call that was let go goes on, and its thread ends with it.
  ~Aside();
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;

  /// Does it there, and waits. As it may outlast whoever asks for it, it holds all that it touches itself.
  /// @return false: cancelled (within 50 ms). The call is let go, and from now on none is done any more.
  /// @throws what the call throws.
  bool run(std::function<void()> call, const RunContext& context);

 private:
  struct Desk;
  static void serve(const std::shared_ptr<Desk>& desk);
  std::shared_ptr<Desk> desk_;
  std::thread thread_;
};

}  // namespace glisson
