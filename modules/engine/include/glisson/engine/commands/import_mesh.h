// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/core/units.h"
#include "glisson/engine/command.h"

namespace glisson::engine {

/// A tetrahedral mesh as it is: node order and all.
struct ImportMesh {
  std::filesystem::path path;
  LengthUnit unit = LengthUnit::millimetre;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
