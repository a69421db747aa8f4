// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/set_video.h"

#include "glisson/engine/parts/named_video.h"
#include "glisson/engine/parts/video.h"
#include "glisson/stereo/picture_io.h"

namespace glisson::engine {

CommandTraits SetVideo::traits() const {
  return {.code = "set_video",
          .writes = {part::video, part::named_video},
          .lane = Lane::edits,
          .notice = Notice::files};
}

Cancellable<Applied> SetVideo::apply(const CaseState& state, const RunContext& context) const {
  const auto video = stereo::StereoVideo::open(left, right, context);  // refused here, not at the first frame
  if (!video) return {};
  Applied applied{state};
  applied.state[part::video] = std::make_shared<const VideoSource>(VideoSource{left, right, (*video)->cut()});
  applied.state[part::named_video] = nullptr;
  applied.figures["video_frames"] = (*video)->frame_count();
  applied.figures["video_frames_per_second"] = (*video)->frames_per_second();
  return applied;
}

}  // namespace glisson::engine
