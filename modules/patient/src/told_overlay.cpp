// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/told_overlay.h"

#include "glisson/patient/label_map.h"

namespace glisson {

ToldOverlay told(const OverlayFrame& overlay) {
  ToldOverlay result;
  result.texts["level"] = level_code(overlay.level());
  result.texts["validity"] = validity_code(overlay.validity);
  for (const LesionVerdict& verdict : overlay.lesions) {
    const std::string lesion = structure_name(verdict.lesion);
    result.texts[lesion + "_level"] = level_code(verdict.level);
    result.texts[lesion + "_reason"] = lesion_reason_code(verdict.reason);
    if (verdict.reach <= 0.0) continue;
    result.figures[lesion + "_expected_error_mm"] = 1e3 * verdict.expected;
    result.figures[lesion + "_reach_95_mm"] = 1e3 * verdict.reach;
  }
  return result;
}

}  // namespace glisson
