// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glisson::guidance {

/// A reason with hysteresis, so that it does not flicker: it needs several bad measurements in a row to
/// stand, and more good ones to go. What is neither bad nor good leaves it as it is.
class Alarm {
 public:
  /// @pre both positive.
  Alarm(int raise_after, int clear_after) : raise_after_(raise_after), clear_after_(clear_after) {}

  /// @param value measured. @param bad from which it is bad; good: below `good`. @pre good <= bad.
  void push(double value, double bad, double good) {
    bad_ = value >= bad ? bad_ + 1 : 0;
    good_ = value < good ? good_ + 1 : 0;
    if (bad_ >= raise_after_) stands_ = true;
    if (good_ >= clear_after_) stands_ = false;
  }
  /// Without waiting, as at the start.
  void set(bool stands) {
    stands_ = stands;
    bad_ = good_ = 0;
  }
  bool stands() const { return stands_; }

 private:
  int raise_after_, clear_after_;
  int bad_ = 0, good_ = 0;
  bool stands_ = false;
};

}  // namespace glisson::guidance
