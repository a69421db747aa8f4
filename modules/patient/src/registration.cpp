// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/registration.h"

namespace glisson {

const char* validity_code(Validity validity) {
  switch (validity) {
    case Validity::valid:
      return "valid";
    case Validity::not_started:
      return "not_started";
    case Validity::too_few_points:
      return "too_few_points";
    case Validity::inconsistent_motion:
      return "inconsistent_motion";
    case Validity::residual_too_large:
      return "residual_too_large";
    case Validity::mechanics_failed:
      return "mechanics_failed";
    case Validity::stale:
      return "stale";
  }
  return "unknown";
}

}  // namespace glisson
