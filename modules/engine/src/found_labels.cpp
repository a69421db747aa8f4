// SPDX-License-Identifier: GPL-3.0-or-later
#include "found_labels.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/engine/parts/preview.h"
#include "glisson/engine/parts/seeds.h"
#include "label_steps.h"
#include "steps/segment.h"

namespace glisson::engine {
namespace {

/// What is told before a minute of computing: a difference needs one grid.
void require_comparable(const CaseState& state, const std::set<Label>& edited) {
  if (!state[part::labels]->voxels.grid().same_as(state[part::image]->grid))
    throw InputError("labels", structure_names(edited), "was corrected by hand on the voxels of another CT",
                     "Open this CT as a new case, or allow it (--replace-edited)");
}

Figures figures_of(const SegmentationOffer& offer) {
  Figures figures;
  const double ml = 1e-3 * offer.image->grid.voxel_volume_mm3();
  for (const auto& [label, shift] : offer.difference.labels) {
    figures["gained_" + structure_name(label) + "_ml"] = ml * static_cast<double>(shift.gained);
    figures["lost_" + structure_name(label) + "_ml"] = ml * static_cast<double>(shift.lost);
  }
  figures["hand_corrected_voxels"] = static_cast<double>(offer.difference.hand_voxels);
  figures["hand_corrected_voxels_changed"] = static_cast<double>(offer.difference.hand_changed);
  return figures;
}

bool changes_any(const LabelDifference& difference, const std::set<Label>& labels) {
  return std::any_of(labels.begin(), labels.end(),
                     [&](Label label) { return difference.labels.contains(label); });
}

}  // namespace

SegmentationOffer offer_of(const CaseState& state, const std::set<Label>& edited, bool keeps_labels,
                           FoundLabels found) {
  SegmentationOffer offer;
  offer.labels = std::move(found.labels);
  offer.notes = std::move(found.notes);
  offer.base = state[part::labels];
  offer.image = state[part::image];
  offer.seeds = std::move(found.seeds);
  offer.hand = hand_corrected(state);
  offer.edited = edited;
  offer.difference = label_difference(offer.base->voxels, offer.labels.voxels, offer.hand);
  offer.keeps_labels = keeps_labels;
  return offer;
}

Applied put_offer(const CaseState& state, SegmentationOffer offer, OverHandWork over_hand_work) {
  Applied applied{state, figures_of(offer), offer.notes};
  if (over_hand_work == OverHandWork::offer && changes_any(offer.difference, offer.edited)) {
    applied.state[part::preview] = nullptr;
    applied.state[part::offer] = std::make_shared<const SegmentationOffer>(std::move(offer));
    return applied;
  }
  take_offer(applied.state, offer, over_hand_work == OverHandWork::keep_hand);
  applied.figures.merge(label_figures(applied.state));
  return applied;
}

Cancellable<Applied> put_found_labels(const CaseState& state, const std::set<Label>& edited,
                                      OverHandWork over_hand_work, bool keeps_labels,
                                      const std::function<Cancellable<FoundLabels>()>& find) {
  if (!edited.empty() && over_hand_work == OverHandWork::refuse) throw hand_work_error(edited);
  const bool compares =
      !edited.empty() && (over_hand_work != OverHandWork::replace ||
                          state[part::labels]->voxels.grid().same_as(state[part::image]->grid));
  if (compares) require_comparable(state, edited);
  auto found = find();
  if (!found) return {};
  if (compares)
    return put_offer(state, offer_of(state, edited, keeps_labels, std::move(*found)), over_hand_work);
  Applied applied{state, {}, found->notes};
  put_grown_labels(applied.state, std::move(*found), step::segment);
  applied.figures = label_figures(applied.state);
  return applied;
}

}  // namespace glisson::engine
