// SPDX-License-Identifier: GPL-3.0-or-later
// What follows the operation: the tracker on the case's parts.
#include "glisson/core/error.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/stereo/faults.h"

namespace glisson::engine {
namespace {

class TrackerFollower : public Follower {
 public:
  TrackerFollower(const CaseState& state, const StartTracking& command)
      : tracker_(effective_model(state), *state[part::registration], command.options),
        steps_per_cloud_(command.steps_per_cloud) {
    if (command.source == StartTracking::Source::frames)
      tracker_.begin(*state[part::rig], state[part::frame]->frame, state[part::frame]->mask);
  }
  OverlayFrame follow(const LiveInput& input) override {
    if (const auto* cloud = std::get_if<IndexedCloud>(&input))
      return tracker_.follow(cloud->cloud, cloud->index, cloud->seconds, steps_per_cloud_);
    return tracker_.follow(std::get<StereoFrame>(input));
  }

 private:
  guidance::Tracker tracker_;
  int steps_per_cloud_;
};

}  // namespace

std::unique_ptr<Follower> make_follower(const CaseState& state, const StartTracking& command) {
  if (const auto first = obstacle(state, command)) throw error_of(*first);
  if (command.source == StartTracking::Source::frames)
    stereo::require_rig_of(*state[part::rig], state[part::frame]->frame.left);
  return std::make_unique<TrackerFollower>(state, command);
}

}  // namespace glisson::engine
