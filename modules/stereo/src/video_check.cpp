// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/stereo/faults.h"
#include "glisson/stereo/picture_io.h"

namespace glisson::stereo {

void VideoCheckOptions::validate() const { require(every >= 1, "every is 1 at least"); }

Cancellable<VideoFaults> check_video(StereoVideo& video, const std::optional<StereoRig>& rig,
                                     const VideoCheckOptions& options, const RunContext& context,
                                     const FaultTold& told) {
  options.validate();
  const double expected = std::max(1.0, static_cast<double>(video.frame_count()));
  SequenceCheck sequence;
  VideoFaults result;
  const auto add = [&](const FrameFault& fault) {
    result.faults.push_back(fault);
    if (told) told(fault);
  };
  for (StereoFrame frame; video.read(frame); ++result.frames) {
    if (context.cancelled()) return {};
    context.progress(std::min(1.0, result.frames / expected), "check.frame");
    const std::vector<FrameFault> found = sequence.push(frame);
    for (const FrameFault& fault : found) add(fault);
    if (!rig || result.frames % options.every != 0 || !found.empty()) continue;
    for (const Fault fault : check_pair(frame.left, frame.right, *rig).faults) add({frame.index, fault});
  }
  result.skipped = video.skipped();
  return result;
}

}  // namespace glisson::stereo
