// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/segmentation/segment.h"

namespace glisson::engine {

/// Replaces all seeds; nothing is segmented.
struct SetSeeds {
  segmentation::Seeds seeds;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
