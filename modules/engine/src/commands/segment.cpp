// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/segment.h"

#include "glisson/core/error.h"
#include "glisson/engine/hand_edits.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/seeds.h"
#include "label_steps.h"

namespace glisson::engine {
namespace {

void refuse_to_replace(const std::set<Label>& edited) {
  std::string names;
  for (const Label label : edited) names += (names.empty() ? "" : ", ") + structure_name(label);
  throw InputError("labels", names, "was corrected by hand and would be replaced",
                   "Lock it (--lock), leave it out of what is found anew (--only), or allow it "
                   "(--replace-edited)");
}

}  // namespace

std::set<Label> Segment::would_replace(const CaseState& state) const {
  std::set<Label> replaced = edited_by_hand(state);
  for (const Label label : options.locked) replaced.erase(label);
  const auto& seeds = state[part::seeds];
  if (keeps_labels() && seeds)
    std::erase_if(replaced, [&](Label label) {
      return !segmentation::is_found_anew(label, options.structures, *seeds);
    });
  return replaced;
}

CommandTraits Segment::traits() const {
  CommandTraits traits{.code = "segment",
                       .reads = {part::image, part::seeds},
                       .writes = labels_and_review(),
                       .needs = {part::image, part::seeds}};
  // What is kept of the labels stays as old as it was.
  if (keeps_labels()) traits.reads.add(part::labels);
  return traits;
}

Cancellable<Applied> Segment::apply(const CaseState& state, const RunContext& context,
                                    const Services& services) const {
  if (const auto edited = would_replace(state); !edited.empty() && !replace_edited) refuse_to_replace(edited);
  auto segmented =
      segmentation::segment(*state[part::image], *state[part::seeds], options, context,
                            keeps_labels() ? state[part::labels].get() : nullptr, services.show_evolving);
  if (!segmented) return {};
  Applied applied{state};
  applied.notes = segmented->report.notes;
  const auto touched = replace_labels(applied.state, std::move(segmented->labels), {kSegmentStep, 0, 0.0});
  // What a machine made is there to be looked at.
  Review review = review_or_none(state);
  for (const Label label : touched) review[label] = ReviewState::to_review;
  put_review(applied.state, review);
  report_labels(applied.state, applied.figures);
  return applied;
}

}  // namespace glisson::engine
