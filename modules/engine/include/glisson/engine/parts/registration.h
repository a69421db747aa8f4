// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"
#include "glisson/patient/registration.h"

namespace glisson::engine {

namespace part {
/// Where the model lies in the camera's frame.
extern const PartOf<Registration> registration;
}  // namespace part

}  // namespace glisson::engine
