// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/load_stereo_pair.h"

#include "glisson/engine/parts/frame.h"
#include "glisson/stereo/picture_io.h"
#include "stereo_frame.h"

namespace glisson::engine {

CommandTraits LoadStereoPair::traits() const {
  return {.code = "load_stereo_pair", .writes = {part::frame}, .notice = Notice::files};
}

Cancellable<Applied> LoadStereoPair::apply(const CaseState& state, const RunContext&) const {
  StereoInput input;
  input.frame.left = stereo::read_picture(left);
  input.frame.right = stereo::read_picture(right);
  if (!mask.empty()) input.mask = stereo::read_picture(mask);
  return with_frame(state, std::move(input), mask);
}

}  // namespace glisson::engine
