// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/patient/label_map.h"

namespace glisson::engine {

/// How far a person has come with a label.
struct SetReview {
  Label label = 0;
  ReviewState state = ReviewState::not_started;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
