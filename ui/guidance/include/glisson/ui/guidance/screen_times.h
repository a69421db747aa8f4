// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <deque>
#include <optional>
#include <string>

namespace glisson::ui {

/// How long live pictures took from the camera to the screen: from when the feed handed a frame over until
/// the picture that shows it was painted. What the window's system and the monitor add is not in it.
class ScreenTimes {
 public:
  using Clock = std::chrono::steady_clock;
  /// Of another playing.
  void clear();
  void add(Clock::time_point taken, Clock::time_point drawn);
  /// Pictures since clear().
  int count() const { return count_; }
  /// Seconds, over the last 600 pictures; empty: there is none. @pre share in [0, 1]
  std::optional<double> percentile(double share) const;
  /// Pictures a second over the last two seconds before the last one; 0: unknown yet.
  double rate() const;

 private:
  std::deque<double> seconds_;
  std::deque<Clock::time_point> drawn_;
  int count_ = 0;
};

/// For a log: "camera to screen 23 ms median, 41 ms 99 %, 29.8 frames/s, 1234 pictures".
std::string line_of(const ScreenTimes& times);

}  // namespace glisson::ui
