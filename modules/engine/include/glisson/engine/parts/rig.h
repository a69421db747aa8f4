// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"
#include "glisson/geometry/camera.h"

namespace glisson::engine {

namespace part {
/// The stereo laparoscope's calibration.
extern const PartOf<StereoRig> rig;
}  // namespace part

}  // namespace glisson::engine
