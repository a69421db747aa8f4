// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "glisson/core/json_file.h"
#include "glisson/patient/registration.h"

namespace glisson {

/// What files and the command line tell of an overlay, flat.
struct ToldOverlay {
  /// Codes: "level", "validity"; of each lesion "lesion_1_level", "lesion_1_reason".
  std::map<std::string, std::string> texts;
  /// Of each lesion whose 95 % region is known: "lesion_1_expected_error_mm", "lesion_1_reach_95_mm".
  Figures figures;
};
/// Of one frame.
ToldOverlay told(const OverlayFrame& overlay);

}  // namespace glisson
