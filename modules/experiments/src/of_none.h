// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

/// @file
/// Figures of what did not happen: not numbers, so that no aim is met by them, and "-" in tables.

namespace glisson::experiments {

/// Not a number of nothing.
inline double share_of(int part, int whole) {
  return whole > 0 ? part / static_cast<double>(whole) : std::nan("");
}

/// @param format of one number.
inline std::string figure_text(const char* format, double value) {
  if (std::isnan(value)) return "-";
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace glisson::experiments
