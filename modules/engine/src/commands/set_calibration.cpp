// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/set_calibration.h"

#include <optional>

#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/parts/video.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/source.h"

namespace glisson::engine {
namespace {

/// How pictures of this size were cut out of the video's. A camera that is in use is not opened once more.
std::optional<stereo::Cut> cut_of(const VideoSource& video, int width, int height) {
  if (!video.right.empty()) return {};
  if (!video.cut) return stereo::cut_of(video.left, width, height);
  return stereo::leaves(*video.cut, width, height) ? video.cut : std::nullopt;
}

/// The file's, for the case's pictures and video.
StereoRig rig_in(const std::filesystem::path& path, const CaseState& state) {
  const auto& frame = state[part::frame];
  const auto& video = state[part::video];
  const int width = frame ? frame->frame.left.width : 0, height = frame ? frame->frame.left.height : 0;
  return stereo::read_calibration_for(path, width, height,
                                      video ? cut_of(*video, width, height) : std::nullopt);
}

}  // namespace

CommandTraits SetCalibration::traits() const {
  return {.code = "set_calibration",
          .writes = {part::rig},
          .needs = stereo::is_text_calibration(path) ? Needs{part::frame} : Needs{},
          .lane = Lane::edits,
          .notice = Notice::files};
}

Cancellable<Applied> SetCalibration::apply(const CaseState& state, const RunContext&) const {
  Applied applied{state};
  const auto rig = std::make_shared<const StereoRig>(rig_in(path, state));
  applied.notes = stereo::calibration_doubts(*rig);
  applied.state[part::rig] = rig;
  return applied;
}

}  // namespace glisson::engine
