// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "glisson/engine/command.h"

namespace glisson::engine {

/// Writes the surfaces of the liver and its structures into a folder (see write_case_surfaces). Changes no
/// part.
struct ExportSurfaces {
  std::filesystem::path folder;
  std::string ending = ".stl";

  CommandTraits traits() const;
  /// `surfaces_written` in the figures; what was left out in the notes.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
