// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace glisson::insilico {

/// A tool that comes in from the side, touches the organ, takes it along or presses it, lets go and leaves.
/// The same seed gives the same use.
struct ToolUse {
  double way_mm = 0.0;    ///< of the tip: outward (it has taken hold and lifts), negative inward; 0: no tool
  double begins_s = 0.8;  ///< it enters; a third of a second later it touches
  double moves_s = 0.8;   ///< from there to the end of its way, as long back
  double holds_s = 0.7;   ///< in between
  double tip_mm = 7.0;    ///< how far around the tip tissue goes along (one deviation)
  /// From which side, and how far off the point that hides the lesion in the middle of the picture.
  std::uint64_t seed = 1;
  static ToolUse lifts() { return {.way_mm = 25.0}; }
  static ToolUse presses() { return {.way_mm = -15.0}; }
  /// @throws InputError naming the option.
  void validate() const;
};

}  // namespace glisson::insilico
