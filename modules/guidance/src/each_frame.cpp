// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/guidance/each_frame.h"

#include <algorithm>

#include "glisson/stereo/picture_io.h"

namespace glisson::guidance {

double FrameSpan::done_with(int frame, int frames) const {
  if (frames == 0 && last < 0) return 1.0;
  const int end = last >= 0 ? last + 1 : frames;
  return std::clamp((frame - first + 1.0) / std::max(1, end - first), 0.0, 1.0);
}

void each_frame(stereo::StereoVideo& video, const FrameSpan& span, const FrameKnower& known,
                const FrameTaker& take) {
  const int first = video.is_live() ? 0 : span.first;
  for (StereoFrame frame; video.read(frame);) {
    if (frame.index < first) continue;
    if (const auto overlay = known(frame)) take(frame, *overlay);
    if (span.last >= 0 && frame.index >= span.last) break;
  }
}

}  // namespace glisson::guidance
