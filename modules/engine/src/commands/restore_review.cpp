// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/restore_review.h"

#include "glisson/core/error.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"

namespace glisson::engine {

CommandTraits RestoreReview::traits() const {
  return {.code = "restore_review",
          .reads = {part::model},  // a later step makes neither part out of date
          .writes = {part::proposals, part::landmarks},
          .needs = {part::model, part::proposals},
          .current = {part::proposals},
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> RestoreReview::apply(const CaseState& state, const RunContext&) const {
  require(proposals != nullptr, "a review has proposals");
  // One transfer is told from another by where it put the atlas.
  const Points &now = state[part::proposals]->surface, &then = proposals->surface;
  if (now.rows() != then.rows() || now != then)
    throw InputError("RestoreReview", "proposals", "were made anew since then", "Review the new ones");
  Applied applied{state};
  applied.state[part::proposals] = proposals;
  applied.state[part::landmarks] = landmarks;
  return applied;
}

}  // namespace glisson::engine
