// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "frame_clock.h"

namespace glisson::guidance {

/// When the organ is to be looked for by its texture. An attempt takes about as long as three frames, so it
/// must not be made often for long.
class LookAgain {
 public:
  /// @param is_lost without an overlay, because it is not where it was.
  bool is_time(const FrameClock& clock, bool is_lost) {
    // Seconds. After kLost, every kLookAgain during kEager, then every kLookSeldom.
    constexpr double kLost = 0.1, kEager = 1.0, kLookAgain = 0.1, kLookSeldom = 0.3;
    if (!is_lost) {
      lost_at_.reset();
      return false;
    }
    if (!lost_at_) lost_at_ = looked_at_ = clock.now() - clock.passed();
    const bool is_seldom = clock.is_due(*lost_at_, kLost + kEager);
    if (!clock.is_due(*lost_at_, kLost) || !clock.is_due(looked_at_, is_seldom ? kLookSeldom : kLookAgain))
      return false;
    looked_at_ = clock.now();
    return true;
  }

 private:
  std::optional<double> lost_at_;  ///< the last frame with an overlay; empty: it has one
  double looked_at_ = 0.0;         ///< since then
};

}  // namespace glisson::guidance
