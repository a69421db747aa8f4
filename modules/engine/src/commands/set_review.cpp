// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/set_review.h"

#include "glisson/core/error.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/review.h"
#include "label_steps.h"

namespace glisson::engine {

CommandTraits SetReview::traits() const {
  return {.code = "set_review",
          .reads = {part::labels},
          .writes = {part::review},
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> SetReview::apply(const CaseState& before, const RunContext&) const {
  if (seen && seen != before[part::labels])
    throw InputError("labels", structure_name(label), "has changed since it was looked at",
                     "Look at it as it is now, and say it again");
  Applied applied{before};
  Review review = review_or_none(before);
  review[label] = state;
  put_review(applied.state, review);
  return applied;
}

}  // namespace glisson::engine
