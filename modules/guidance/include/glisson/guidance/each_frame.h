// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"

namespace glisson::stereo {
class StereoVideo;
}

namespace glisson::guidance {

/// Which frames of a video are looked at, by their numbers, both included.
struct FrameSpan {
  int first = 0;  ///< of a live source the first that comes: it counts anew when it is opened again
  int last = -1;  ///< below 0: to the video's end
  /// Share that is done with a frame, in [0, 1].
  /// @param frames of the whole video; 0: unknown, as of a live device, which is always at its end.
  double done_with(int frame, int frames) const;
};

/// What is known of a frame. Empty: nothing, and the frame is passed over.
using FrameKnower = std::function<std::optional<OverlayFrame>(const StereoFrame&)>;
using FrameTaker = std::function<void(const StereoFrame&, const OverlayFrame&)>;

/// The one loop over a video whose organ is followed, or was: every frame of the span in its order, none
/// twice. What `known` and `take` throw ends it.
/// @throws InputError when the video breaks off, as StereoVideo::read().
void each_frame(stereo::StereoVideo& video, const FrameSpan& span, const FrameKnower& known,
                const FrameTaker& take);

}  // namespace glisson::guidance
