// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <set>

#include "glisson/engine/command.h"
#include "glisson/engine/hand_edits.h"
#include "glisson/patient/label_map.h"
#include "label_steps.h"

/// @file
/// What every command does alike that finds labels by machine: what a hand has corrected is replaced only
/// when that was said, and what would change of it is told.

namespace glisson::engine {

/// @param edited labels that a hand has corrected and that would be found anew.
/// @param keeps_labels the finding starts from the case's labels (see Segment::keeps_labels()).
/// @param find the work itself; empty: cancelled.
/// @throws InputError where they must not be replaced, or cannot be compared.
Cancellable<Applied> put_found_labels(const CaseState& state, const std::set<Label>& edited,
                                      OverHandWork over_hand_work, bool keeps_labels,
                                      const std::function<Cancellable<FoundLabels>()>& find);

/// What would change the labels `edited` of the case. @param keeps_labels see above.
/// @pre the case's labels lie on its image's grid, and so do those that were found.
SegmentationOffer offer_of(const CaseState& state, const std::set<Label>& edited, bool keeps_labels,
                           FoundLabels found);

/// What becomes of it: a part of the case, until a person decides, or labels at once where that was said or
/// none of those labels would change. Its figures tell the difference. @pre over_hand_work is not refuse.
Applied put_offer(const CaseState& state, SegmentationOffer offer, OverHandWork over_hand_work);

}  // namespace glisson::engine
