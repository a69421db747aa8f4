// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/case_state.h"

namespace glisson::engine {

/// Where the stereo video of the operation lies.
struct VideoSource {
  std::filesystem::path left, right;  ///< `right` empty: `left` holds both views side by side
};

namespace part {
extern const PartOf<VideoSource> video;
}  // namespace part

}  // namespace glisson::engine
