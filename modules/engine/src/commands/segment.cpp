// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/segment.h"

#include <string>
#include <utility>
#include <vector>

#include "found_labels.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/locks.h"
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
  const segmentation::Seeds& seeds = *state[part::seeds];
  segmentation::PartlyAnew anew;
  anew.is_whole = true;
  // In a region all but lesions is found anew in part.
  anew.is_kept = [&](Label label) {
    const bool in_part = command.options.region && !is_lesion(label);
    return kept != nullptr && (label == structure::kBackground || in_part ||
                               !segmentation::is_found_anew(label, command.options, image.grid, seeds));
  };
  if (command.options.region)
    anew.is_answered = [&](const std::string& note) {
      return segmentation::is_answered(note, *command.options.region, seeds, segmented->report.notes);
    };
  return FoundLabels{
      std::move(segmented->labels),
      segmentation::with_kept_notes(told_of_labels(state), anew, std::move(segmented->report.notes)),
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

std::optional<segmentation::Hindrance> Segment::hindrance(const CaseState& state) const {
  return segmentation::hindrance(options, state[part::image]->grid, *state[part::seeds],
                                 keeps_labels() && state[part::labels]);
}

CommandTraits Segment::traits() const {
  CommandTraits traits{.code = "segment",
                       .reads = {part::image, part::seeds, part::locks},
                       .writes = labels_and_review(),
                       .needs = {part::image, part::seeds}};
  // What is kept of the labels stays as old as it was.
  if (keeps_labels() || over_hand_work == OverHandWork::keep_hand) traits.reads.add(part::labels);
  return traits;
}

Cancellable<Applied> Segment::apply(const CaseState& state, const RunContext& context,
                                    const Services& services) const {
  segmentation::require_something_to_find(options, state[part::image]->grid, *state[part::seeds]);
  return put_found_labels(state, would_replace(state), over_hand_work, keeps_labels(),
                          [&] { return found(*this, state, context, services); });
}

}  // namespace glisson::engine
