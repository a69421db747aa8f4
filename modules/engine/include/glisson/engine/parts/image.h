// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"
#include "glisson/volume/image.h"

namespace glisson::engine {

namespace part {
/// The CT or MR.
extern const PartOf<Image> image;
}  // namespace part

}  // namespace glisson::engine
