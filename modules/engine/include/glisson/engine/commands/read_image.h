// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "glisson/engine/command.h"
#include "glisson/volume/dicom_source.h"

namespace glisson::engine {

/// Reads a CT or MR (see read_image) and hands it over as its result, for ImportImage: whether it can be read
/// is known before anything is asked. Changes no part.
struct ReadImage {
  using Result = Scan;
  std::filesystem::path path;
  std::string series = {};  ///< UID or number, where there are several

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
