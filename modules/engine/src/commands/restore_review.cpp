// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/restore_review.h"

#include "../review_step.h"
#include "glisson/engine/parts/proposals.h"

namespace glisson::engine {

CommandTraits RestoreReview::traits() const { return review_traits("restore_review"); }

Cancellable<Applied> RestoreReview::apply(const CaseState& state, const RunContext&) const {
  const atlas::Structure structure = before.structure;
  if (!landmark_is_as_reviewed(state, structure))
    return with_review(state, before, placed_points(state, structure), placed_deviations(state, structure));
  return with_review(state, before, landmark, deviations);
}

}  // namespace glisson::engine
