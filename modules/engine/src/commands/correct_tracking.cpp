// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/correct_tracking.h"

#include "changed_live.h"

namespace glisson::engine {

CommandTraits CorrectTracking::traits() const { return correction_traits("correct_tracking"); }

Cancellable<Applied> CorrectTracking::apply(const CaseState& state, const RunContext&,
                                            const Services& services) const {
  Follower& follower = follower_of(services);
  return with_live(state, follower.correct(correction), follower);
}

}  // namespace glisson::engine
