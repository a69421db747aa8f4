// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/atlas/atlas.h"
#include "glisson/engine/command.h"

namespace glisson::engine {

/// Transfers an atlas to the case's liver. What a person had decided of former proposals is asked again.
struct ProposeLandmarks {
  std::shared_ptr<const atlas::Atlas> atlas;

  CommandTraits traits() const;
  /// @pre an atlas
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
