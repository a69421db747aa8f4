// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/command.h"

namespace glisson::engine {

/// OpenCV YAML; or a folder of plain text (stereo::read_text_calibration, mm), for pictures of the size of
/// the case's frame.
struct SetCalibration {
  std::filesystem::path path;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
