// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "glisson/engine/case_state.h"
#include "glisson/stereo/source.h"

namespace glisson::engine {

/// Where the stereo video of the operation lies. Of a case that was opened: one that a person of this
/// computer has chosen, or that lies in the case's folder; others are only named (named_video.h).
struct VideoSource {
  std::filesystem::path left, right;  ///< `right` empty: `left` holds both views side by side
  /// How its views were cut when a person opened it. Empty: they were not, or it came with a case's files.
  std::optional<stereo::Cut> cut = {};
};

namespace part {
extern const PartOf<VideoSource> video;
}  // namespace part

}  // namespace glisson::engine
