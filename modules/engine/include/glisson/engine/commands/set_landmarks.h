// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/patient/patient_model.h"

namespace glisson::engine {

/// Replaces all landmarks by these; none at all removes them.
struct SetLandmarks {
  Landmarks landmarks;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
