// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"
#include "glisson/stereo/regions.h"

namespace glisson::engine {

namespace part {
/// What a person drew on the pair: which organ and which landmark is seen where.
extern const PartOf<stereo::Regions> regions;
}  // namespace part

}  // namespace glisson::engine
