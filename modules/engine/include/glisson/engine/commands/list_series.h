// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "glisson/engine/command.h"
#include "glisson/volume/series.h"

namespace glisson::engine {

/// Says as its result which DICOM series a folder or an archive holds. Changes no part.
struct ListSeries {
  using Result = std::vector<DicomSeries>;
  std::filesystem::path path;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
