// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/stereo/regions.h"

namespace glisson::engine {

/// Replaces all regions of the case's stereo pair; regions that name no pair are taken for this one's.
/// @throws InputError regions of other pictures.
struct SetRegions {
  stereo::Regions regions;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
