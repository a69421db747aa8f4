// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/correct_tracking.h"

#include "corrected_live.h"
#include "glisson/engine/parts/live.h"

namespace glisson::engine {

CommandTraits CorrectTracking::traits() const {
  return {.code = "correct_tracking",
          .reads = {part::live},
          .writes = {part::live},
          .needs = {part::live},
          .current = {part::live},
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> CorrectTracking::apply(const CaseState& state, const RunContext&,
                                            const Services& services) const {
  Follower& follower = follower_of(services);
  return corrected_live(state, follower.correct(correction), follower);
}

}  // namespace glisson::engine
