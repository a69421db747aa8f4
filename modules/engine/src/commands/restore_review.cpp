// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/restore_review.h"

#include "../review_step.h"

namespace glisson::engine {

CommandTraits RestoreReview::traits() const { return review_traits("restore_review"); }

Cancellable<Applied> RestoreReview::apply(const CaseState& state, const RunContext&) const {
  return with_review(state, before, landmark, deviations);
}

}  // namespace glisson::engine
