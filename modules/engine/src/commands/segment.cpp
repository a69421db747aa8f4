// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/segment.h"

#include <algorithm>

#include "glisson/core/error.h"
#include "glisson/engine/hand_edits.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/engine/parts/preview.h"
#include "glisson/engine/parts/seeds.h"
#include "label_steps.h"

namespace glisson::engine {
namespace {

/// What is told before a minute of computing: a difference needs one grid.
void require_comparable(const CaseState& state, const std::set<Label>& edited) {
  if (!state[part::labels]->voxels.grid().same_as(state[part::image]->grid))
    throw InputError("labels", structure_names(edited), "was corrected by hand on the voxels of another CT",
                     "Open this CT as a new case, or allow it (--replace-edited)");
}

SegmentationOffer offer_of(const CaseState& state, const Segment& command, const std::set<Label>& edited,
                           segmentation::Segmented segmented) {
  SegmentationOffer offer;
  offer.labels = std::move(segmented.labels);
  offer.notes = std::move(segmented.report.notes);
  offer.base = state[part::labels];
  offer.image = state[part::image];
  offer.seeds = state[part::seeds];
  offer.hand = hand_corrected(state);
  offer.edited = edited;
  offer.difference = label_difference(offer.base->voxels, offer.labels.voxels, offer.hand);
  offer.keeps_labels = command.keeps_labels();
  return offer;
}

void report_difference(const SegmentationOffer& offer, Figures& figures) {
  const double ml = 1e-3 * offer.image->grid.voxel_volume_mm3();
  for (const auto& [label, shift] : offer.difference.labels) {
    figures["gained_" + structure_name(label) + "_ml"] = ml * static_cast<double>(shift.gained);
    figures["lost_" + structure_name(label) + "_ml"] = ml * static_cast<double>(shift.lost);
  }
  figures["hand_corrected_voxels"] = static_cast<double>(offer.difference.hand_voxels);
  figures["hand_corrected_voxels_changed"] = static_cast<double>(offer.difference.hand_changed);
}

bool changes_any(const LabelDifference& difference, const std::set<Label>& labels) {
  return std::any_of(labels.begin(), labels.end(),
                     [&](Label label) { return difference.labels.contains(label); });
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
  if (keeps_labels() || over_hand_work == OverHandWork::keep_hand) traits.reads.add(part::labels);
  return traits;
}

Cancellable<Applied> Segment::apply(const CaseState& state, const RunContext& context,
                                    const Services& services) const {
  const std::set<Label> edited = would_replace(state);
  if (!edited.empty() && over_hand_work == OverHandWork::refuse) throw hand_work_error(edited);
  const bool compares =
      !edited.empty() && (over_hand_work != OverHandWork::replace ||
                          state[part::labels]->voxels.grid().same_as(state[part::image]->grid));
  if (compares) require_comparable(state, edited);
  auto segmented =
      segmentation::segment(*state[part::image], *state[part::seeds], options, context,
                            keeps_labels() ? state[part::labels].get() : nullptr, services.show_evolving);
  if (!segmented) return {};
  Applied applied{state};
  applied.notes = segmented->report.notes;
  if (!compares) {
    put_grown_labels(applied.state, std::move(segmented->labels), kSegmentStep);
    report_labels(applied.state, applied.figures);
    return applied;
  }
  SegmentationOffer offer = offer_of(state, *this, edited, std::move(*segmented));
  report_difference(offer, applied.figures);
  if (over_hand_work == OverHandWork::offer && changes_any(offer.difference, edited)) {
    applied.state[part::preview] = nullptr;
    applied.state[part::offer] = std::make_shared<const SegmentationOffer>(std::move(offer));
    return applied;
  }
  take_offer(applied.state, offer, over_hand_work == OverHandWork::keep_hand);
  report_labels(applied.state, applied.figures);
  return applied;
}

}  // namespace glisson::engine
