// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/geometry/camera.h"

namespace glisson::scene {

/// How a lens bends a pinhole's picture. The pinhole is larger than the camera's picture where the lens sees
/// farther than an undistorted one of the same size would.
struct LensMaps {
  Camera pinhole;  ///< no distortion; same focal lengths and skew, shifted principal point
  /// For every pixel of the camera's picture (row-major), where in the pinhole's picture it looks.
  std::vector<float> x, y;
};

/// @pre the camera has a size and focal lengths. A lens that would need more than twice the size is cut
/// there.
LensMaps make_lens_maps(const Camera& camera);

}  // namespace glisson::scene
