// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_steps.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/locks.h"
#include "glisson/engine/parts/preview.h"
#include "glisson/engine/parts/review.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/segmentation/kept_notes.h"
#include "steps/segment.h"
#include "steps/segment_around_hand.h"

namespace glisson::engine {
namespace {

/// Whoever touches a label has begun with it; what was approved must be looked at again.
Review review_after(const Review& review, const std::set<Label>& touched) {
  Review next = review;
  for (const Label label : touched) {
    ReviewState& state = next[label];
    if (state == ReviewState::not_started) state = ReviewState::in_progress;
    if (state == ReviewState::approved) state = ReviewState::to_review;
  }
  return next;
}

editing::History history_or_none(const CaseState& state) {
  return state[part::history] ? *state[part::history] : editing::History();
}

/// Notes that hold when other seeds come.
std::vector<std::string> placed(std::vector<std::string> notes, const CaseState& state) {
  const auto& seeds = state[part::seeds];
  return seeds ? segmentation::with_places(std::move(notes), *seeds) : notes;
}

/// Puts labels in place, with their figures and what is told of them; preview and offer were of others.
void put_labels(CaseState& state, FoundLabels made, editing::History history) {
  LabelMap& labels = made.labels;
  const auto image = state[part::image];
  const bool measurable = image && image->grid.same_as(labels.voxels.grid());
  state[part::statistics] = std::make_shared<const segmentation::LabelStatistics>(
      labels, measurable ? image.get() : nullptr, state[part::statistics].get());
  state[part::labels] = std::make_shared<const LabelMap>(std::move(labels));
  state[part::label_notes] =
      std::make_shared<const std::vector<std::string>>(placed(std::move(made.notes), state));
  state[part::history] = std::make_shared<const editing::History>(std::move(history));
  state[part::preview] = nullptr;
  state[part::offer] = nullptr;
}

/// Puts the labels in place that a step made of `before`. @return those of which a voxel came or went.
std::set<Label> step_to(CaseState& state, const LabelMap& before, FoundLabels after,
                        const editing::StepName& name, std::uint64_t gesture = 0) {
  LabelChanges changes = after.labels.voxels.changes_since(before.voxels);
  std::set<Label> touched = labels_touched(changes);
  editing::History history =
      history_or_none(state).with({name, std::move(changes), before.infos, after.labels.infos, gesture,
                                   kept_notes(state), placed(after.notes, state)});
  put_labels(state, std::move(after), std::move(history));
  return touched;
}

}  // namespace

std::string structure_names(const std::set<Label>& labels) {
  std::string names;
  for (const Label label : labels) names += (names.empty() ? "" : ", ") + structure_name(label);
  return names;
}

std::set<Label> labels_touched(const LabelChanges& changes) {
  std::set<Label> touched;
  std::pair<Label, Label> last{0, 0};
  for (const LabelChange& change : changes)
    for (std::size_t i = 0; i < LabelVolume::Brick().size(); ++i) {
      const std::pair<Label, Label> now{change.before ? (*change.before)[i] : Label{0},
                                        change.after ? (*change.after)[i] : Label{0}};
      if (now.first == now.second || now == last) continue;
      touched.insert({now.first, now.second});
      last = now;
    }
  touched.erase(structure::kBackground);
  return touched;
}

Parts labels_and_review() { return {part::labels, part::review, part::preview, part::offer}; }

LabelMap labels_or_none(const CaseState& state) {
  if (state[part::labels]) return *state[part::labels];
  LabelMap none;
  none.voxels = LabelVolume(state[part::image]->grid);
  return none;
}

Review review_or_none(const CaseState& state) {
  return state[part::review] ? *state[part::review] : Review{};
}

void require_labels_fit_image(const CaseState& state) {
  if (state[part::labels])
    require_same_grid(state[part::labels]->voxels.grid(), state[part::image]->grid,
                      "the case's labels and its image");
}

void require_unlocked(const CaseState& state, const LabelMap& after) {
  const std::set<Label> locked = locked_in(state);
  const auto& before = state[part::labels];
  if (locked.empty() || !before) return;
  const auto all_of = [](const LabelVolume& voxels) {
    return labels_touched(voxels.changes_since(LabelVolume(voxels.grid())));
  };
  std::set<Label> touched;
  if (before->voxels.grid().same_as(after.voxels.grid())) {
    touched = labels_touched(after.voxels.changes_since(before->voxels));
  } else {  // there each of them is another
    touched = all_of(before->voxels);
    touched.merge(all_of(after.voxels));
  }
  std::erase_if(touched, [&](Label label) { return !locked.contains(label); });
  if (!touched.empty())
    throw InputError("labels", structure_names(touched), "is locked and would be changed", "Unlock it first");
}

void put_review(CaseState& state, const Review& review) {
  if (review != review_or_none(state)) state[part::review] = std::make_shared<const Review>(review);
}

void put_edited_labels(CaseState& state, const LabelMap& before, FoundLabels after,
                       const editing::StepName& name, std::uint64_t gesture) {
  const Review review = review_or_none(state);
  put_review(state, review_after(review, step_to(state, before, std::move(after), name, gesture)));
}

/// Not so of labels that were made of an image before this one.
bool are_of_this_image(const CaseState& state) {
  const auto& inputs = state.stamp(part::labels).made_from;
  const auto image = inputs.find(part::image);
  return image == inputs.end() || image->second == state.stamp(part::image).revision;
}

std::set<Label> replace_labels(CaseState& state, FoundLabels found, const editing::StepName& name) {
  require_unlocked(state, found.labels);
  const VolumeGrid& grid = found.labels.voxels.grid();
  const auto former = state[part::labels];
  if (former && former->voxels.grid().same_as(grid) && are_of_this_image(state))
    return step_to(state, *former, std::move(found), name);
  // Steps on another grid lead nowhere, those on another image to labels that are not of this one, nor is
  // there a way back to no labels at all.
  std::set<Label> touched = labels_touched(found.labels.voxels.changes_since(LabelVolume(grid)));
  put_labels(state, std::move(found), editing::History());
  return touched;
}

void step_labels(CaseState& state, StepDirection direction) {
  const bool back = direction == StepDirection::back;
  const editing::History history = history_or_none(state);
  const auto labels = state[part::labels];
  if (!labels || !(back ? history.can_undo() : history.can_redo()))
    throw InputError("labels", "history", back ? "there is no step to undo" : "there is no step to redo",
                     back ? "Edit the labels first" : "Only what was undone last can be redone");
  const editing::History::Step& step = back ? history.undo_step() : history.redo_step();
  put_review(state, review_after(review_or_none(state), labels_touched(step.changes)));
  auto [stepped, then] = back ? history.undo(*labels) : history.redo(*labels);
  put_labels(state, {std::move(stepped), back ? step.notes_before : step.notes_after}, std::move(then));
}

void put_grown_labels(CaseState& state, FoundLabels found, const StepKind& kind) {
  Review review = review_or_none(state);
  for (const Label label : replace_labels(state, std::move(found), kind.name()))
    review[label] = ReviewState::to_review;
  put_review(state, review);
}

void take_offer(CaseState& state, const SegmentationOffer& offer, bool keeps_hand) {
  LabelMap labels = offer.labels;
  if (keeps_hand) {
    labels.voxels = keeping_hand(offer.base->voxels, offer.labels.voxels, offer.hand);
    for (const LabelInfo& info : offer.base->infos)
      if (std::none_of(labels.infos.begin(), labels.infos.end(),
                       [&](const LabelInfo& other) { return other.code == info.code; }))
        labels.infos.push_back(info);
  }
  FoundLabels taken{std::move(labels), offer.notes};
  if (offer.clicked) {
    require_unlocked(state, taken.labels);
    put_edited_labels(state, *offer.base, std::move(taken), *offer.clicked, 0);
  } else {
    put_grown_labels(state, std::move(taken), keeps_hand ? step::segment_around_hand : step::segment);
  }
}

Figures label_figures(const CaseState& state) {
  Figures figures;
  for (const auto& [label, of] : state[part::statistics]->figures())
    figures["label_" + structure_name(label) + "_ml"] = of.ml;
  return figures;
}

}  // namespace glisson::engine
