// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/core/units.h"
#include "glisson/engine/command.h"
#include "glisson/model/build.h"

namespace glisson::engine {

/// A model from closed surfaces: a folder by structure, or one file.
struct ImportSurfaces {
  std::filesystem::path path;
  LengthUnit unit = LengthUnit::millimetre;
  model::ModelOptions options;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
