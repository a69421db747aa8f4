// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/stereo/side.h"

namespace glisson::stereo {

/// Where the other picture can show what one picture shows at a pixel: the ray through the pixel, projected
/// with both lenses' distortion (so it is a curve), from the depth `near` to `far`.
struct EpipolarLine {
  std::vector<Eigen::Vector2d> pixels;  ///< of the other picture, nearest first; only what it shows
  std::vector<double> depths;           ///< along the first camera's z, metres, one a pixel
};
/// @param pixel of the picture `side`, as taken. Where its lens maps nothing to it the line is empty. @pre 0
/// < near < far.
EpipolarLine epipolar_line(const StereoRig& rig, Side side, const Eigen::Vector2d& pixel, double near = 0.01,
                           double far = 1.0);

}  // namespace glisson::stereo
