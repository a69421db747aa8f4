// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/set_regions.h"

#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/regions.h"

namespace glisson::engine {

CommandTraits SetRegions::traits() const {
  return {.code = "set_regions",
          .reads = {part::frame},
          .writes = {part::regions},
          .needs = {part::frame},
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> SetRegions::apply(const CaseState& state, const RunContext&) const {
  const StereoFrame& frame = state[part::frame]->frame;
  stereo::require_regions_of(regions, frame.left, frame.right);
  stereo::Regions of_this_frame = regions;
  if (of_this_frame.identity.empty())
    of_this_frame.identity = stereo::frame_identity(frame.left, frame.right);
  Applied applied{state};
  applied.state[part::regions] = std::make_shared<const stereo::Regions>(std::move(of_this_frame));
  return applied;
}

}  // namespace glisson::engine
