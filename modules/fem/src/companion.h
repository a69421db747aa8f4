// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace glisson::fem {

/// A second thread that waits for work. Handing it some costs about 10 us, much less than a new thread.
class Companion {
 public:
  using Work = std::function<void()>;

  Companion();
  ~Companion();
  Companion(const Companion&) = delete;
  Companion& operator=(const Companion&) = delete;

  /// Both at once, `theirs` on the second thread; returns when both are done. Neither may throw.
  void together(const Work& mine, const Work& theirs);

 private:
  enum Turn : int { resting, working, leaving };
  std::atomic<int> turn_ = resting;
  const Work* work_ = nullptr;
  std::thread thread_;
};

}  // namespace glisson::fem
