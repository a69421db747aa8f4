// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/patient/labelled_cloud.h"

namespace glisson {

/// What is wrong with clouds, points.
struct CloudFaults {
  int repeated = 0;       ///< the same place again, of the same look and feature: taken out
  int without_depth = 0;  ///< at the lens itself, where writers put what they have no depth of: taken out
  int turned = 0;         ///< normals that faced away from the camera, which saw the front: turned
  int with_normals = 0;   ///< points that have one
  int behind = 0;         ///< behind the lens: they stay, since a cloud may be in a frame of its own
  /// As codes for a person: "cloud.repeated 12", "cloud.behind 40"; none where there was nothing. Normals are
  /// told of where more than a tenth were turned: noise turns some of those that are seen edge on.
  std::vector<std::string> notes() const;
};

/// A cloud without the points that are none: repeated ones have no neighbours at a distance, and those at the
/// origin would pull the organ to the lens. Its normals face the camera that saw them.
/// @param from_camera a camera in the origin has seen it.
/// @param faults what was found is added.
LabelledCloud sound_cloud(const LabelledCloud& cloud, bool from_camera, CloudFaults& faults);

}  // namespace glisson
