// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/set_review.h"

#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/review.h"
#include "label_steps.h"
#include "seen.h"

namespace glisson::engine {

CommandTraits SetReview::traits() const {
  return {.code = "set_review",
          .reads = {part::labels},
          .writes = {part::review},
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> SetReview::apply(const CaseState& before, const RunContext&) const {
  require_seen(before, part::labels, seen);
  Applied applied{before};
  Review review = review_or_none(before);
  review[label] = state;
  put_review(applied.state, review);
  return applied;
}

}  // namespace glisson::engine
