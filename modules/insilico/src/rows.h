// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <thread>

namespace glisson::insilico {

/// Calls work(y) for every row of a picture, on two threads. Rows must not depend on one another: the result
/// is then the same whoever computes them.
template <class Work>
void for_each_row(int rows, const Work& work) {
  constexpr int kChunk = 8;
  std::atomic<int> next{0};
  const auto run = [&] {
    for (int begin = next.fetch_add(kChunk); begin < rows; begin = next.fetch_add(kChunk))
      for (int y = begin; y < rows && y < begin + kChunk; ++y) work(y);
  };
  const std::jthread other(run);
  run();
}

}  // namespace glisson::insilico
