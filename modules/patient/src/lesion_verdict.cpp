// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/lesion_verdict.h"

namespace glisson {

const char* level_code(Level level) {
  switch (level) {
    case Level::valid:
      return "valid";
    case Level::degraded:
      return "degraded";
    case Level::withdrawn:
      return "withdrawn";
  }
  return "unknown";
}

const char* lesion_reason_code(LesionReason reason) {
  switch (reason) {
    case LesionReason::known:
      return "known";
    case LesionReason::with_the_whole:
      return "with_the_whole";
    case LesionReason::error_unknown:
      return "error_unknown";
    case LesionReason::refused_start:
      return "refused_start";
    case LesionReason::start_uncertain:
      return "start_uncertain";
    case LesionReason::far_from_points:
      return "far_from_points";
    case LesionReason::long_unseen:
      return "long_unseen";
  }
  return "unknown";
}

}  // namespace glisson
