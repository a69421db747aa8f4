// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/stop_tracking.h"

#include "glisson/engine/parts/live.h"

namespace glisson::engine {

CommandTraits StopTracking::traits() const {
  return {.code = "stop_tracking",
          .writes = {part::live},
          .lane = Lane::edits,
          .notice = Notice::quiet,
          .live = LiveLane::tracking};
}

Cancellable<Applied> StopTracking::apply(const CaseState& state, const RunContext&) const {
  Applied applied{state};
  applied.state[part::live] = nullptr;
  applied.live = [](LiveLanes& lanes) { lanes.end_tracking(); };
  return applied;
}

}  // namespace glisson::engine
