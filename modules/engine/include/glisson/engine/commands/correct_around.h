// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "glisson/engine/command.h"
#include "glisson/engine/hand_edits.h"
#include "glisson/segmentation/correct_around.h"
#include "glisson/segmentation/grow_around.h"

namespace glisson::engine {

/// Corrects labels around clicks, one after the other, and nowhere else, as one step of their history: the
/// liver's (see segmentation::correct_around()), then vessels and lesions (see segmentation::grow_around()).
/// They count as work by hand: growth replaces it only when that was said. So it is with a lesion that a hand
/// has drawn, which a click would find anew (see drawn_by_hand()).
struct CorrectAround {
  std::vector<segmentation::Click> clicks;
  /// Those that the clicks lie among. The command brings them along, so that one click after another is
  /// placed without waiting for the first.
  segmentation::Seeds seeds;
  std::vector<Label> locked;
  std::vector<segmentation::StructureClick> grown = {};  ///< clicks on vessels and lesions, after the others
  OverHandWork over_hand_work = OverHandWork::refuse;

  /// Lesions that a hand has drawn and that would be found anew.
  std::set<Label> would_replace(const CaseState& state) const;
  CommandTraits traits() const;
  /// figures: voxels_changed and changed_ml, of all clicks together (a voxel that two of them change counts
  /// twice); reach_mm, how far the farthest lies from its click. Over drawn lesions also those of Segment;
  /// none has changed while the part `offer` waits.
  /// @throws InputError drawn lesions, where that is refused; an offer that waits.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
