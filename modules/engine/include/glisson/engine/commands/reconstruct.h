// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/stereo/reconstruct.h"

namespace glisson::engine {

/// The points of the whole pair, then those in regions with their labels (stereo::reconstruct_pair). A new
/// pair is looked at first and refused for its faults; the figures pair_matches and pair_rows_px tell. Where
/// only the regions have changed since the last time, the points are not made again.
struct Reconstruct {
  stereo::ReconstructOptions options;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
