// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/core/share_out.h"

namespace glisson::insilico {

/// Calls work(y) for every row of a picture, on two threads. Rows must not depend on one another: the result
/// is then the same whoever computes them.
template <class Work>
void for_each_row(int rows, const Work& work) {
  share_out_runs(static_cast<std::size_t>(rows), 1, [&](std::size_t first, std::size_t end) {
    for (std::size_t y = first; y < end; ++y) work(static_cast<int>(y));
  });
}

}  // namespace glisson::insilico
