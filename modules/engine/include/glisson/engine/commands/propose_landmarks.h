// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/atlas/atlas.h"
#include "glisson/engine/command.h"

namespace glisson::engine {

/// The liver's fine surface of a model; of a bare mesh its own. CT frame, metres.
const TriangleMesh& fine_liver(const PatientModel& model);

/// Transfers an atlas to the case's liver. What a person has placed by hand is evidence and lies where it was
/// placed. Of former proposals those that a person has moved stay; the others are asked again, and landmarks
/// that were merely accepted are none until then.
struct ProposeLandmarks {
  std::shared_ptr<const atlas::Atlas> atlas;

  CommandTraits traits() const;
  /// @pre an atlas
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
