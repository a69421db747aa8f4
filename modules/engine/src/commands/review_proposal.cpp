// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/review_proposal.h"

#include "../review_step.h"
#include "glisson/atlas/review.h"
#include "glisson/engine/parts/proposals.h"
#include "seen.h"

namespace glisson::engine {

CommandTraits ReviewProposal::traits() const { return review_traits("review_proposal"); }

Cancellable<Applied> ReviewProposal::apply(const CaseState& state, const RunContext&) const {
  require_seen(state, part::proposals, seen);
  const atlas::Proposal reviewed = atlas::reviewed(require_proposed(state, structure), decision, moved);
  return with_decision(state, reviewed);
}

}  // namespace glisson::engine
