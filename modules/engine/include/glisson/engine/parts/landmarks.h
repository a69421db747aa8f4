// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"
#include "glisson/patient/patient_model.h"

namespace glisson::engine {

namespace part {
/// What a person placed or accepted.
extern const PartOf<Landmarks> landmarks;
}  // namespace part

}  // namespace glisson::engine
