// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"
#include "glisson/patient/label_map.h"

namespace glisson::engine {

namespace part {
/// How far a person has come with each label.
extern const PartOf<Review> review;
}  // namespace part

}  // namespace glisson::engine
