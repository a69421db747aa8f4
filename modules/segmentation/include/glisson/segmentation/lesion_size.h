// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/patient/label_map.h"
#include "glisson/volume/morphology.h"

namespace glisson::segmentation {

/// The two set voxels whose centres lie farthest apart, exactly (not along an axis, not in one slice).
struct LongestDiameter {
  double mm = 0.0;                             ///< between the centres; 0: one voxel or none
  Eigen::Vector3i from{0, 0, 0}, to{0, 0, 0};  ///< indices; from lies before `to` in memory
};
/// Over all set voxels, whether they are one piece or not, by the mask's spacing; indices in the mask. An
/// empty mask gives 0.
LongestDiameter longest_diameter(const Mask& mask);
double longest_diameter_mm(const Mask& mask);
/// Of one label; indices in the volume.
LongestDiameter longest_diameter(const LabelVolume& labels, Label label);

}  // namespace glisson::segmentation
