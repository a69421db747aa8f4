// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace glisson::guidance {

/// A reason with hysteresis, so that it does not flicker: it must be measured bad for a while to stand, and
/// good for longer to go. What is neither bad nor good leaves it as it is. The while is a number of
/// measurements in a row where these are made in even steps of time, else seconds.
class Alarm {
 public:
  /// @pre neither negative. Zero: at once.
  Alarm(double raise_after, double clear_after) : raise_after_(raise_after), clear_after_(clear_after) {}

  /// @param value measured. @param bad from which it is bad; good: below `good`. @pre good <= bad.
  /// @param step for how much of the while it counts: one measurement, or the seconds since the one before.
  ///   However large it is, one measurement is never all of it.
  void push(double value, double bad, double good, double step = 1.0) {
    bad_ = value >= bad ? bad_ + part_of(raise_after_, step) : 0.0;
    good_ = value < good ? good_ + part_of(clear_after_, step) : 0.0;
    if (value >= bad && bad_ >= raise_after_ - kRounding) stands_ = true;
    if (value < good && good_ >= clear_after_ - kRounding) stands_ = false;
  }
  /// Without waiting, as at the start.
  void set(bool stands) {
    stands_ = stands;
    bad_ = good_ = 0.0;
  }
  bool stands() const { return stands_; }

 private:
  static constexpr double kRounding = 1e-6;
  static double part_of(double wait, double step) { return std::min(step, 0.5 * wait); }

  double raise_after_, clear_after_;
  double bad_ = 0.0, good_ = 0.0;
  bool stands_ = false;
};

}  // namespace glisson::guidance
