// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/picture.h"
#include "glisson/stereo/regions.h"

namespace glisson::stereo {

/// The part of a cloud that lies in regions.
struct LabelledPart {
  LabelledCloud cloud;
  std::vector<int> kept;         ///< index in the whole cloud of each point
  double area_cm2 = 0.0;         ///< of the surface within the regions, where the whole cloud knows it
  double density_per_cm2 = 0.0;  ///< points / area; 0: no area
};

/// Gives each point of a cloud the feature of the region of either picture in which it is seen (notch over
/// margin over surface) and drops those in none: so other regions need no other reconstruction. About 0.1 s.
/// @param whole left camera's frame, metres, with normals: Reconstructed::cloud.
/// @param mask empty, or one byte a pixel of the left image: bounds the area.
/// @param regions without any, everything is kept as surface; the area is 0 then.
/// @return an empty cloud where no point lies in a region. @pre a normal for each point.
LabelledPart label(const LabelledCloud& whole, const StereoRig& rig, const Picture& mask,
                   const Regions& regions);

}  // namespace glisson::stereo
