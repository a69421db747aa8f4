// SPDX-License-Identifier: GPL-3.0-or-later
#include "companion.h"

namespace glisson::fem {

Companion::Companion()
    : thread_([this] {
        for (;;) {
          turn_.wait(resting, std::memory_order_acquire);
          if (turn_.load(std::memory_order_acquire) == leaving) return;
          (*work_)();
          turn_.store(resting, std::memory_order_release);
          turn_.notify_one();
        }
      }) {}

Companion::~Companion() {
  turn_.store(leaving, std::memory_order_release);
  turn_.notify_one();
  thread_.join();
}

void Companion::together(const Work& mine, const Work& theirs) {
  work_ = &theirs;
  turn_.store(working, std::memory_order_release);
  turn_.notify_one();
  mine();
  turn_.wait(working, std::memory_order_acquire);
}

}  // namespace glisson::fem
