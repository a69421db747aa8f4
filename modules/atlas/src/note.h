// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <string>

namespace glisson::atlas {

/// "atlas.unusual_shape 1.6": a doubt's code with its value.
inline std::string note(const std::string& code, double value, int decimals) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return code + " " + text;
}

}  // namespace glisson::atlas
