// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/start_tracking.h"

#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/engine/parts/video.h"

namespace glisson::engine {

CommandTraits StartTracking::traits() const {
  CommandTraits traits{
      .code = "start_tracking",
      .reads = {part::model, part::landmarks, part::tissue, part::rig, part::frame, part::registration},
      .writes = {part::live},
      .needs = {part::registration, part::model},
      .current = {part::registration},
      .accepted = {part::registration},
      .lane = Lane::edits,
      .notice = Notice::quiet,
      .live = LiveLane::tracking};
  if (source != Source::clouds) traits.needs.insert(traits.needs.end(), {part::rig, part::frame});
  if (source == Source::video) traits.needs.push_back(part::video);
  return traits;
}

Cancellable<Applied> StartTracking::apply(const CaseState& state, const RunContext&,
                                          const Services& services) const {
  const std::shared_ptr<Follower> follower = services.make_follower(state, *this);
  Applied applied{state};
  applied.state[part::live] = std::make_shared<const LiveState>();
  applied.live = [follower](LiveLanes& lanes) { lanes.begin_tracking(follower); };
  return applied;
}

}  // namespace glisson::engine
