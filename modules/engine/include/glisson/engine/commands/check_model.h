// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/engine/command.h"
#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/model.h"

namespace glisson::engine {

/// A person has looked at the model.
struct CheckModel {
  ModelCheck check;
  /// The one that the person has looked at; null: whatever the case holds.
  std::shared_ptr<const model::BuiltModel> seen = {};

  CommandTraits traits() const;
  /// @throws InputError `seen` is not what the case holds.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
