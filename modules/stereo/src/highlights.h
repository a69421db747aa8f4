// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/core.hpp>

#include "glisson/patient/picture.h"

namespace glisson::stereo {

/// Non-zero where the light mirrors itself on wet tissue, and a little around: such spots move with the
/// camera. Tissue is red, so all three channels are high only there; grey pictures show saturation only.
cv::Mat highlights(const Picture& picture);

}  // namespace glisson::stereo
