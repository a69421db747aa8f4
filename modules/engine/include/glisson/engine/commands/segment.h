// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>

#include "glisson/engine/command.h"
#include "glisson/engine/hand_edits.h"
#include "glisson/segmentation/segment.h"

namespace glisson::engine {

/// Where only some structures or a region are found anew, or labels are locked, the rest of the case's labels
/// is kept. What a hand has corrected is replaced only when that was said. The liver's contour is shown on
/// its way (see Snapshot::evolving).
struct Segment {
  segmentation::SegmentationOptions options;
  OverHandWork over_hand_work = OverHandWork::refuse;

  bool keeps_labels() const {
    return options.region || !(options.structures == segmentation::Structures{}) || !options.locked.empty();
  }
  /// Labels that a hand has corrected (see edited_by_hand()) and that would be found anew, or be gone.
  std::set<Label> would_replace(const CaseState& state) const;
  /// Why growth cannot begin; empty: it can. @pre what the command needs is there.
  std::optional<segmentation::Hindrance> hindrance(const CaseState& state) const;
  CommandTraits traits() const;
  /// What would change of the corrected labels is told in the figures, whatever is done about it.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context,
                             const Services& services) const;
};

}  // namespace glisson::engine
