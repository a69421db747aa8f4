// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/decide_segmentation.h"

#include "glisson/core/error.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/locks.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/engine/parts/seeds.h"
#include "label_steps.h"
#include "seen.h"

namespace glisson::engine {
namespace {

/// @throws InputError it no longer fits.
Applied with_offer(const CaseState& state, bool keeps_hand) {
  const SegmentationOffer& offer = *state[part::offer];
  if (!offer.fits(state))
    throw InputError("segmentation", "", "was made of another CT, other seeds or other labels",
                     "Segment again");
  Applied applied{state, {}, offer.notes};
  take_offer(applied.state, offer, keeps_hand);
  applied.figures = label_figures(applied.state);
  return applied;
}

}  // namespace

CommandTraits DecideSegmentation::traits() const {
  CommandTraits traits{.code = "decide_segmentation",
                       .reads = {part::image, part::offer, part::locks},
                       .writes = labels_and_review(),
                       .needs = {part::offer},
                       .lane = Lane::edits,
                       .notice = Notice::quiet};
  if (choice == Choice::keep_all) traits.writes = {part::offer};
  if (!seen || seen->seeds) traits.reads.add(part::seeds);
  if (keeps_labels || choice == Choice::keep_hand) traits.reads.add(part::labels);
  return traits;
}

Cancellable<Applied> DecideSegmentation::apply(const CaseState& state, const RunContext&) const {
  require_seen(state, part::offer, seen);
  if (choice != Choice::keep_all) return with_offer(state, choice == Choice::keep_hand);
  Applied applied{state};
  applied.state[part::offer] = nullptr;
  return applied;
}

}  // namespace glisson::engine
