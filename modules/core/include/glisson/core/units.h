// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// @file
/// Lengths that do not mix. The engine counts in SI (metres), files and screens in millimetres; a bare double
/// is never a length at a boundary between the two.

namespace glisson {

class Millimetres;

/// A length in metres: what every computation uses.
class Metres {
 public:
  constexpr Metres() = default;
  constexpr explicit Metres(double value) : value_(value) {}
  constexpr Metres(Millimetres length);  // NOLINT: lossless, and the point of having two types
  constexpr double value() const { return value_; }

 private:
  double value_ = 0.0;
};

/// A length in millimetres: what files hold and screens show.
class Millimetres {
 public:
  constexpr Millimetres() = default;
  constexpr explicit Millimetres(double value) : value_(value) {}
  constexpr Millimetres(Metres length) : value_(length.value() * 1e3) {}  // NOLINT: see Metres
  constexpr double value() const { return value_; }

 private:
  double value_ = 0.0;
};

constexpr Metres::Metres(Millimetres length) : value_(length.value() * 1e-3) {}

/// The unit in which a file's coordinates are written.
enum class LengthUnit { millimetre, centimetre, metre };

/// Metres per unit.
constexpr double metres_per(LengthUnit unit) {
  return unit == LengthUnit::millimetre ? 1e-3 : unit == LengthUnit::centimetre ? 1e-2 : 1.0;
}

}  // namespace glisson
