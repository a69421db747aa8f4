// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/engine/command.h"
#include "glisson/patient/label_map.h"

namespace glisson::engine {

/// How far a person has come with a label. @throws InputError in apply(): `seen` is not what the case holds.
struct SetReview {
  Label label = 0;
  ReviewState state = ReviewState::not_started;
  /// The labels that the person has looked at; null: whatever the case holds.
  std::shared_ptr<const LabelMap> seen = {};

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
