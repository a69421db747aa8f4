// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/segmentation/segment.h"

namespace glisson::engine {

/// Where only some structures or a region are found anew, or labels are locked, the rest of the case's labels
/// is kept. The liver's contour is shown on its way (see Snapshot::evolving).
struct Segment {
  segmentation::SegmentationOptions options;

  bool keeps_labels() const {
    return options.region || !(options.structures == segmentation::Structures{}) || !options.locked.empty();
  }
  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context,
                             const Services& services) const;
};

}  // namespace glisson::engine
