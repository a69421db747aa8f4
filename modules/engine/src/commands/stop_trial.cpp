// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/stop_trial.h"

namespace glisson::engine {

CommandTraits StopTrial::traits() const {
  return {.code = "stop_trial", .lane = Lane::edits, .live = LiveLane::trial};
}

Cancellable<Applied> StopTrial::apply(const CaseState& state, const RunContext&) const {
  Applied applied{state};
  applied.live = [](LiveLanes& lanes) { lanes.end_trial(); };
  return applied;
}

}  // namespace glisson::engine
