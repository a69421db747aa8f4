// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/engine/command.h"
#include "glisson/engine/parts/offer.h"

namespace glisson::engine {

/// What a person says to the part `offer`: it is taken, taken but for the voxels that a hand has corrected
/// (one step of the history either way), or let go.
struct DecideSegmentation {
  enum class Choice { take, keep_hand, keep_all };
  Choice choice = Choice::keep_all;
  /// As the offer has it: what is kept of the labels stays as old as it was.
  bool keeps_labels = true;
  /// The offer that the person has looked at; null: whatever the case holds.
  std::shared_ptr<const SegmentationOffer> seen = {};

  CommandTraits traits() const;
  /// @throws InputError `seen` is not what the case holds; the offer is of another CT, other seeds or other
  /// labels than the case's; a locked label would change.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
