// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"
#include "glisson/patient/registration.h"

namespace glisson::engine {

/// A registration that may replace the one from which the organ is followed. Either it was made again
/// meanwhile, or, once that one has been taken, it is the former one.
struct OtherRegistration {
  Registration registration;
  bool is_former = false;  ///< it has been replaced; what follows then tells of the one that replaced it
  bool is_better = false;  ///< by evidence that neither has used (registration::RegisteredAgain)
  double former_gap = 0.0, gap = 0.0;  ///< metres, from tissue that was kept out, before and after
  double moved = 0.0;                  ///< metres, mean way of the nodes
};

namespace part {
/// Not in the files.
extern const PartOf<OtherRegistration> other_registration;
}  // namespace part

}  // namespace glisson::engine
