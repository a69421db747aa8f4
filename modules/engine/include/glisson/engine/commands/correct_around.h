// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/engine/command.h"
#include "glisson/segmentation/correct_around.h"

namespace glisson::engine {

/// Corrects the liver's labels around a click, and nowhere else, as one step of their history (see
/// segmentation::correct_around()). The click counts as work by hand: growth replaces it only when that was
/// said.
struct CorrectAround {
  segmentation::Click click;
  /// Those that the click lies among. The command brings them along, so that one click after another is
  /// placed without waiting for the first.
  segmentation::Seeds seeds;
  std::vector<Label> locked;

  CommandTraits traits() const;
  /// figures: voxels_changed, changed_ml, reach_mm.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
