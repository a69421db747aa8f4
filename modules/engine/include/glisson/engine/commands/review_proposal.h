// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/atlas/transfer.h"
#include "glisson/engine/command.h"

namespace glisson::engine {

/// What a person says of one proposal. Accepted and moved ones become landmarks where registration knows the
/// structure (notch, margin, vena cava); of others, and of what is not visible, no landmark
/// remains: registration then goes by what the model itself shows of it, if anything. What a person has
/// placed by hand stays until it is moved or cleared; where another place is accepted the note
/// "landmarks.mark_stays vena_cava" says so.
struct ReviewProposal {
  atlas::Structure structure = atlas::Structure::umbilical_notch;
  atlas::Decision decision = atlas::Decision::accepted;
  /// Where it was moved to (CT frame, metres): as many points as the proposal has, for areas the points of
  /// the contact. Empty unless `decision` is moved.
  PointsIn<CtFrame> moved = {};
  /// The proposals that the person has looked at; null: whatever the case holds.
  std::shared_ptr<const atlas::Transfer> seen = {};

  CommandTraits traits() const;
  /// @throws InputError `seen` is not what the case holds, nothing is proposed for the structure, or another
  /// number of points.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
