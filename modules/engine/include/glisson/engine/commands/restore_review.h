// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/atlas/transfer.h"
#include "glisson/engine/command.h"

namespace glisson::engine {

/// Takes a step of the review back: one proposal and its landmark as they were before. What was done to other
/// structures since stays, and so does a landmark that is no longer what the step had left: only the decision
/// is taken back then.
struct RestoreReview {
  atlas::Proposal before;
  PointsIn<CtFrame> landmark = {};  ///< as placed_points() had it; none: there was none
  Eigen::VectorXd deviations = {};  ///< of these, as placed_deviations() had it, metres; none: 0

  CommandTraits traits() const;
  /// @throws InputError nothing is proposed for the structure any more.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
