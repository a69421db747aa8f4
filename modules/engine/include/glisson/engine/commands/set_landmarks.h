// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/engine/command.h"
#include "glisson/engine/parts/model.h"
#include "glisson/patient/patient_model.h"

namespace glisson::engine {

/// Replaces all landmarks by these; none at all removes them.
struct SetLandmarks {
  Landmarks landmarks;
  /// The model on which the person has placed them; null: whatever the case holds.
  std::shared_ptr<const model::BuiltModel> seen = {};

  CommandTraits traits() const;
  /// @throws InputError `seen` is not what the case holds.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
