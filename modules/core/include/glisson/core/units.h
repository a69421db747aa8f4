// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

/// @file
/// Units of everything that crosses a room's public headers: SI. Lengths and positions are metres, unless the
/// name says otherwise: `_mm`, `_mm2` and `_mm3` are millimetres. The rooms that have such names are those at
/// the scanner's voxels and at settings that a person types; tests/architecture/house.txt lists them and a
/// test holds the list against the headers. Files are in millimetres where their format names no unit.

namespace glisson {

/// The unit in which a file's coordinates are written.
enum class LengthUnit { millimetre, centimetre, metre };

/// Metres per unit.
constexpr double metres_per(LengthUnit unit) {
  return unit == LengthUnit::millimetre ? 1e-3 : unit == LengthUnit::centimetre ? 1e-2 : 1.0;
}

/// "mm", "cm", "m".
constexpr const char* unit_code(LengthUnit unit) {
  return unit == LengthUnit::millimetre ? "mm" : unit == LengthUnit::centimetre ? "cm" : "m";
}
inline constexpr std::array kLengthUnits = {LengthUnit::millimetre, LengthUnit::centimetre,
                                            LengthUnit::metre};
/// The unit of such a code; empty: none has it.
constexpr std::optional<LengthUnit> unit_named(std::string_view code) {
  for (const LengthUnit unit : kLengthUnits)
    if (code == unit_code(unit)) return unit;
  return {};
}

}  // namespace glisson
