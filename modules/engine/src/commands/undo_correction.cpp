// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/undo_correction.h"

#include "corrected_live.h"
#include "glisson/engine/parts/live.h"

namespace glisson::engine {

CommandTraits UndoCorrection::traits() const {
  return {.code = "undo_correction",
          .reads = {part::live},
          .writes = {part::live},
          .needs = {part::live},
          .current = {part::live},
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> UndoCorrection::apply(const CaseState& state, const RunContext&,
                                           const Services& services) const {
  Follower& follower = follower_of(services);
  return corrected_live(state, follower.undo_correction(), follower);
}

}  // namespace glisson::engine
