// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/atlas/atlas.h"
#include "glisson/engine/command.h"

namespace glisson::engine {

/// The liver's fine surface of a model; of a bare mesh its own. CT frame, metres.
const TriangleMesh& fine_liver(const PatientModel& model);

/// Transfers an atlas to the case's liver. What a person had decided of former proposals is asked again.
struct ProposeLandmarks {
  std::shared_ptr<const atlas::Atlas> atlas;

  CommandTraits traits() const;
  /// @pre an atlas
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
