// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/load_stereo_pair.h"

#include "glisson/engine/parts/frame.h"
#include "glisson/stereo/picture_reader.h"
#include "stereo_frame.h"

namespace glisson::engine {

CommandTraits LoadStereoPair::traits() const {
  return {.code = "load_stereo_pair", .writes = {part::frame}, .notice = Notice::files};
}

Cancellable<Applied> LoadStereoPair::apply(const CaseState& state, const RunContext&) const {
  StereoInput input;
  stereo::PictureReader pictures;
  input.frame.left = pictures.read(left);
  input.frame.right = pictures.read(right);
  if (!mask.empty()) input.mask = pictures.read(mask);
  return with_frame(state, std::move(input), mask);
}

}  // namespace glisson::engine
