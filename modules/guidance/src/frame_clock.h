// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace glisson::guidance {

/// Seconds of the source from frame to frame, however many frames it gives and the machine leaves out. What
/// is judged by it is the same for the same frames on any machine. A source whose time stands or goes back,
/// or that has none, counts as usual.
class FrameClock {
 public:
  /// The next frame. @param source_seconds as its source has it.
  void tick(double source_seconds) {
    passed_ = has_begun_ && source_seconds > source_seconds_ ? source_seconds - source_seconds_ : kUsual;
    now_ += has_begun_ ? passed_ : 0.0;
    source_seconds_ = source_seconds;
    has_begun_ = true;
  }
  double now() const { return now_; }        ///< since the first frame
  double passed() const { return passed_; }  ///< since the frame before
  /// Whether a wait is over, to the nearest frame: what would be later in the next frame than it is early
  /// now is due now.
  bool is_due(double since, double wait) const {
    return now_ + 0.5 * std::min(passed_, kLongest) + 1e-6 >= since + wait;
  }

 private:
  static constexpr double kUsual = 1.0 / 30.0;
  static constexpr double kLongest = 0.2;  ///< a longer one is a gap, not the source's rate
  double now_ = 0.0, passed_ = kUsual, source_seconds_ = 0.0;
  bool has_begun_ = false;
};

}  // namespace glisson::guidance
