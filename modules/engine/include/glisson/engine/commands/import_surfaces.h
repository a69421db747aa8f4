// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "glisson/atlas/atlas.h"
#include "glisson/core/units.h"
#include "glisson/engine/command.h"
#include "glisson/model/build.h"

namespace glisson::engine {

/// A model from closed surfaces: a folder by structure, or one file.
struct ImportSurfaces {
  std::filesystem::path path;
  LengthUnit unit = LengthUnit::millimetre;
  model::ModelOptions options;
  /// The liver's shape is held against it, so that a mirrored one is told; null: it is not asked.
  std::shared_ptr<const atlas::Atlas> atlas = nullptr;
  /// Where it is taken, a liver that lies left of the vena cava is a note, "liver.perhaps_mirrored".
  LeftLiver left_liver = LeftLiver::refused;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
