// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"
#include "glisson/patient/registration.h"

namespace glisson::engine {

/// A registration that may take the place of the one from which the organ is followed: made again while it
/// was followed, or the former one after that was taken.
struct OtherRegistration {
  Registration registration;
  bool is_former = false;  ///< it has been in that place; the rest then tells of the one that is there now
  bool is_better = false;  ///< by evidence that neither has used (registration::RegisteredAgain)
  double former_gap = 0.0, gap = 0.0;  ///< metres, from tissue that was kept out, before and after
  double moved = 0.0;                  ///< metres, mean way of the nodes
};

namespace part {
/// Not in the files.
extern const PartOf<OtherRegistration> other_registration;
}  // namespace part

}  // namespace glisson::engine
