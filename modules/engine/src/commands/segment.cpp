// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/segment.h"

#include <utility>

#include "found_labels.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/segmentation/kept_notes.h"
#include "label_steps.h"

namespace glisson::engine {
namespace {

Cancellable<FoundLabels> found(const Segment& command, const CaseState& state, const RunContext& context,
                               const Services& services) {
  const Image& image = *state[part::image];
  const LabelMap* kept = command.keeps_labels() ? state[part::labels].get() : nullptr;
  auto segmented = segmentation::segment(image, *state[part::seeds], command.options, context, kept,
                                         services.show_evolving);
  if (!segmented) return {};
  // In a region all but lesions is found anew in part.
  const auto is_kept = [&](Label label) {
    return kept != nullptr &&
           ((command.options.region && !is_lesion(label)) ||
            !segmentation::is_found_anew(label, command.options, image.grid, *state[part::seeds]));
  };
  return FoundLabels{
      std::move(segmented->labels),
      segmentation::with_kept_notes(told_of_labels(state), is_kept, std::move(segmented->report.notes)),
      state[part::seeds]};
}

}  // namespace

std::set<Label> Segment::would_replace(const CaseState& state) const {
  std::set<Label> replaced = edited_by_hand(state);
  for (const Label label : options.locked) replaced.erase(label);
  const auto& image = state[part::image];
  const auto& seeds = state[part::seeds];
  if (keeps_labels() && image && seeds)
    std::erase_if(replaced, [&](Label label) {
      return !segmentation::is_found_anew(label, options, image->grid, *seeds);
    });
  return replaced;
}

CommandTraits Segment::traits() const {
  CommandTraits traits{.code = "segment",
                       .reads = {part::image, part::seeds},
                       .writes = labels_and_review(),
                       .needs = {part::image, part::seeds}};
  // What is kept of the labels stays as old as it was.
  if (keeps_labels() || over_hand_work == OverHandWork::keep_hand) traits.reads.add(part::labels);
  return traits;
}

Cancellable<Applied> Segment::apply(const CaseState& state, const RunContext& context,
                                    const Services& services) const {
  return put_found_labels(state, would_replace(state), over_hand_work, keeps_labels(),
                          [&] { return found(*this, state, context, services); });
}

}  // namespace glisson::engine
