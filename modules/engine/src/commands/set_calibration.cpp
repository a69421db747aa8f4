// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/set_calibration.h"

#include <optional>

#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/parts/video.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/source.h"

namespace glisson::engine {
CommandTraits SetCalibration::traits() const {
  return {.code = "set_calibration",
          .writes = {part::rig},
          .needs = stereo::is_text_calibration(path) ? Needs{part::frame} : Needs{},
          .lane = Lane::edits,
          .notice = Notice::files};
}

Cancellable<Applied> SetCalibration::apply(const CaseState& state, const RunContext&) const {
  const auto& frame = state[part::frame];
  const auto& video = state[part::video];
  const int width = frame ? frame->frame.left.width : 0, height = frame ? frame->frame.left.height : 0;
  std::optional<stereo::Cut> cut;
  if (video && video->right.empty()) cut = stereo::cut_of(video->left, width, height);
  Applied applied{state};
  const auto rig = std::make_shared<const StereoRig>(stereo::read_calibration_for(path, width, height, cut));
  applied.notes = stereo::calibration_doubts(*rig);
  applied.state[part::rig] = rig;
  return applied;
}

}  // namespace glisson::engine
