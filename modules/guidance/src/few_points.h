// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "frame_clock.h"
#include "glisson/guidance/judge_options.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"
#include "small_stereo.h"

namespace glisson::guidance {

/// Why too few points are left, from what the two pictures show. Each reason has its own remedy.
class FewPoints {
 public:
  /// @param first what the pictures show is compared with this frame's.
  FewPoints(const StereoRig& rig, const StereoFrame& first, const JudgeOptions& options);

  /// @param clock of the frames.
  /// @return view_lost, picture_lost or views_swapped; too_few_points where the pictures give no reason.
  Validity reason(const StereoFrame& frame, const FrameClock& clock);

 private:
  /// Whether `left` and `right` are surely in this order: stereo sees a good part of what it saw at the
  /// start, and far more than in the other order.
  /// @param seen places that stereo sees in this order.
  bool fits(std::size_t seen, const Picture& left, const Picture& right);
  bool are_swapped(const StereoFrame& frame, const FrameClock& clock);

  JudgeOptions options_;
  SmallStereo stereo_;
  double left_ = 1.0, right_ = 1.0;  ///< detail over noise at the start
  std::size_t seen_ = 0;             ///< places that stereo saw at the start
  bool tells_order_ = false;         ///< whether stereo could tell the order at the start; with converging
                                     ///< cameras it may not
  double looked_ = -1.0;             ///< seconds of the clock; negative: not yet
  bool swapped_ = false;
};

}  // namespace glisson::guidance
