// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace glisson::guidance {

/// The source's own time, in seconds, whatever its frame rate and whatever frames the machine leaves out. So
/// the same frames give the same judgements on any machine. Where the source's time stands still, goes back
/// or is missing, a frame counts as 1/30 s.
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
  /// Whether `wait` seconds have passed since `since`, to the nearest frame: true now if the next frame would
  /// be farther from that moment than this one.
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
