// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/geometry/camera.h"
#include "glisson/geometry/mesh.h"
#include "glisson/patient/picture.h"

namespace glisson::guidance {

/// What of the views shows anything. One channel, non-zero where it does; empty: everywhere.
struct SeenParts {
  Picture left, right;  ///< inside the laparoscope's circle, whose rim stands still whatever moves
  Picture tissue;       ///< of the left view: inside the circle and the mask
};

/// @param mask empty, or of the left view's size, non-zero where tissue may be followed.
/// @throws InputError a picture is empty, or it or the mask is not of the calibration's size.
SeenParts seen_parts(const StereoFrame& first, const StereoRig& rig, const Picture& mask);

/// What of a surface the camera sees, but for what hides it, square metres. @param mesh camera frame.
double seen_area(const TriangleMesh& mesh, const Camera& camera);

}  // namespace glisson::guidance
