// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/start_trial.h"

#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/tissue.h"

namespace glisson::engine {

CommandTraits StartTrial::traits() const {
  return {.code = "start_trial",
          .reads = {part::model, part::landmarks, part::tissue},
          .needs = {part::model},
          .lane = Lane::edits,
          .live = LiveLane::trial};
}

Cancellable<Applied> StartTrial::apply(const CaseState& state, const RunContext& context,
                                       const Services& services) const {
  auto made = services.make_trial(state, options, context);
  if (!made) return {};
  const std::shared_ptr<LoadTrial> mechanics = std::move(*made);
  Applied applied{state};
  applied.live = [mechanics, state](LiveLanes& lanes) { lanes.begin_trial(mechanics, state); };
  return applied;
}

}  // namespace glisson::engine
