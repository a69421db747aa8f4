// SPDX-License-Identifier: GPL-3.0-or-later
#include "stereo_frame.h"

#include <utility>

#include "glisson/stereo/faults.h"

namespace glisson::engine {

Applied with_frame(const CaseState& state, StereoInput input, const std::filesystem::path& mask) {
  stereo::require_one_size(input.frame, input.mask, mask.string());
  Applied applied{state};
  applied.state[part::frame] = std::make_shared<const StereoInput>(std::move(input));
  return applied;
}

}  // namespace glisson::engine
