// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"
#include "glisson/segmentation/segment.h"

namespace glisson::engine {

namespace part {
/// What a person clicked for the segmentation.
extern const PartOf<segmentation::Seeds> seeds;
}  // namespace part

}  // namespace glisson::engine
