// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/undo_correction.h"

#include "changed_live.h"

namespace glisson::engine {

CommandTraits UndoCorrection::traits() const { return correction_traits("undo_correction"); }

Cancellable<Applied> UndoCorrection::apply(const CaseState& state, const RunContext&,
                                           const Services& services) const {
  Follower& follower = follower_of(services);
  return with_live(state, follower.undo_correction(), follower);
}

}  // namespace glisson::engine
