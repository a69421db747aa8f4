// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace glisson::stereo {

/// "1920x1080", as messages tell pictures' sizes and boards' corners.
inline std::string size_text(int across, int down) {
  return std::to_string(across) + "x" + std::to_string(down);
}

}  // namespace glisson::stereo
