// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/engine/case_state.h"
#include "glisson/engine/live.h"
#include "glisson/patient/correction.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"

namespace glisson::engine {

/// What the live view shows. Written by the live lane only.
struct LiveState {
  OverlayFrame overlay;
  StereoFrame frame;
  int frames = 0;                           ///< followed since tracking began
  int frames_late = 0;                      ///< that took longer than a frame's time
  int frames_dropped = 0;                   ///< never followed because a newer one had come
  std::vector<CorrectionMade> corrections;  ///< by hand, that stand; the oldest first
  std::optional<MaskStatus> mask;           ///< empty: no network masks what is not liver
  /// Where the tissue has been seen since tracking began (Follower::tissue_at_start); null: not yet.
  std::shared_ptr<const LabelledCloud> tissue_at_start;
};

namespace part {
/// Not in the files.
extern const PartOf<LiveState> live;
}  // namespace part

}  // namespace glisson::engine
