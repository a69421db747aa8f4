// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/command.h"

namespace glisson::engine {

/// Writes the labels with their names, terminology and review to a file (.seg.nrrd, .nii.gz, ...). Changes no
/// part.
struct ExportLabels {
  std::filesystem::path path;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
