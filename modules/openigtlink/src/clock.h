// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace glisson::openigtlink {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point moment) {
  return std::chrono::duration<double>(Clock::now() - moment).count();
}

}  // namespace glisson::openigtlink
