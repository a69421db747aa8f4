// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/editing/history.h"
#include "glisson/engine/case_state.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/engine/step_kind.h"
#include "glisson/patient/label_map.h"

/// @file
/// What every command about the labels does alike: labels go in with their history, their figures and the
/// review of what they touched.

namespace glisson::engine {

/// Labels that were found, and what is told of them.
struct FoundLabels {
  LabelMap labels;
  std::vector<std::string> notes;
  std::shared_ptr<const segmentation::Seeds> seeds = {};  ///< that they were found from; null: from none
};

/// For errors: "liver, lesion_1".
std::string structure_names(const std::set<Label>& labels);

/// Labels of which a voxel came or went.
std::set<Label> labels_touched(const LabelChanges& changes);

/// What such a command writes, and reads besides the image.
Parts labels_and_review();

/// The case's labels; without any, empty ones on the image's grid. @pre the state has an image.
LabelMap labels_or_none(const CaseState& state);
Review review_or_none(const CaseState& state);
/// @throws InputError when the case's labels lie on another grid than its image.
void require_labels_fit_image(const CaseState& state);

/// @throws InputError naming those of the case's locked labels that these labels would change.
void require_unlocked(const CaseState& state, const LabelMap& after);

/// Stays the same edition when nothing changes.
void put_review(CaseState& state, const Review& review);
/// The labels that an edit made of `before`, as one step of the history. What it touched is to be looked at
/// again.
void put_edited_labels(CaseState& state, const LabelMap& before, FoundLabels after,
                       const editing::StepName& name, std::uint64_t gesture);
/// Labels that a whole step made anew. The review is the caller's. @return those of which a voxel changed.
/// @throws InputError see require_unlocked().
std::set<Label> replace_labels(CaseState& state, FoundLabels found, const editing::StepName& name);

enum class StepDirection { back, forth };
/// One step of the history. @throws InputError when there is none.
void step_labels(CaseState& state, StepDirection direction);

/// The labels that growth found, with their review and figures: what a machine made is there to be looked at.
void put_grown_labels(CaseState& state, FoundLabels found, const StepKind& kind);
/// The same of an offer, with or without the voxels that a hand has corrected.
void take_offer(CaseState& state, const SegmentationOffer& offer, bool keeps_hand);

/// label_NAME_ml of each label. @pre the state has labels.
Figures label_figures(const CaseState& state);

}  // namespace glisson::engine
