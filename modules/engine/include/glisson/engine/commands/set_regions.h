// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/stereo/regions.h"

namespace glisson::engine {

/// Replaces all regions on the registered pair. @throws InputError regions of other pictures.
struct SetRegions {
  stereo::Regions regions;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
