// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/geometry/camera.h"

class vtkRenderer;

namespace glisson::scene {

/// Gives a renderer the view of a pinhole camera that stands in the scene's origin and looks along +z, y down
/// (OpenCV's axes; the scene is in the camera's frame). The whole matrix is reproduced: two focal lengths,
/// skew, and a principal point off the centre. Distortion is not: see LensMaps.
/// @param near, far metres, 0 < near < far.
void set_pinhole_camera(vtkRenderer& renderer, const Camera& camera, double near, double far);

/// Depth along z, metres, of an OpenGL depth value in [0, 1) under the same near and far.
inline double metric_depth(double depth, double near, double far) {
  return near * far / (far - depth * (far - near));
}

}  // namespace glisson::scene
