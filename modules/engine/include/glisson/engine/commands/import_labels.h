// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "glisson/atlas/atlas.h"
#include "glisson/engine/command.h"
#include "glisson/patient/label_map.h"

namespace glisson::engine {

/// Reads labels, recoded by `codes` (empty: Glisson's own codes).
struct ImportLabels {
  std::filesystem::path path;
  LabelCodes codes;
  /// The liver's shape is held against it, so that a mirrored one is told; null: it is not asked.
  std::shared_ptr<const atlas::Atlas> atlas = nullptr;
  /// Where it is taken, a liver that lies left of the vena cava is a note, "liver.perhaps_mirrored".
  LeftLiver left_liver = LeftLiver::refused;

  CommandTraits traits() const;
  /// @throws InputError a locked label would change.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
