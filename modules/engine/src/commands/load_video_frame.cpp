// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/load_video_frame.h"

#include "glisson/core/error.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/video.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/source.h"
#include "stereo_frame.h"

namespace glisson::engine {
namespace {

/// Frame `index` of the video, from 0. @throws InputError it has fewer.
Cancellable<StereoFrame> frame_at(int index, const VideoSource& source, const RunContext& context) {
  const auto video = stereo::StereoVideo::open(source.left, source.right, context);
  if (!video) return {};
  StereoFrame frame;
  for (int i = 0; i <= index; ++i) {
    if (context.cancelled()) return {};
    const bool is_there = (*video)->read(frame);
    if (context.cancelled()) return {};
    if (!is_there)
      throw InputError(source.left.string(), "frame " + std::to_string(index),
                       "the video has only " + std::to_string(i) + " frames", "Choose an earlier frame");
    context.progress(static_cast<double>(i + 1) / (index + 1), "video.seek");
  }
  return frame;
}

}  // namespace

CommandTraits LoadVideoFrame::traits() const {
  return {.code = "load_video_frame",
          .reads = {part::video},
          .writes = {part::frame},
          .needs = {part::video},
          .notice = Notice::files};
}

Cancellable<Applied> LoadVideoFrame::apply(const CaseState& state, const RunContext& context) const {
  StereoInput input;
  if (!mask.empty()) input.mask = stereo::read_picture(mask);
  auto frame = frame_at(index, *state[part::video], context);
  if (!frame) return {};
  input.frame = std::move(*frame);
  return with_frame(state, std::move(input), mask);
}

}  // namespace glisson::engine
