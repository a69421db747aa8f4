// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/patient/labelled_cloud.h"

namespace glisson {

/// What was taken out of clouds, points.
struct CloudFaults {
  int repeated = 0;       ///< the same place again, of the same look and feature
  int without_depth = 0;  ///< at the lens or behind it: writers put there what they have no depth of
  /// As codes for a person: "cloud.repeated 12", "cloud.without_depth 5"; none where there was nothing.
  std::vector<std::string> notes() const;
};

/// A cloud without the points that are none: they have no neighbours at a distance, or lie where nothing can
/// be seen, and would pull the organ there.
/// @param from_camera the cloud is in the left camera's frame: what lies less than 5 mm before the lens goes.
/// @param faults what was taken out is added.
/// @throws InputError more than half of the points lie behind the lens: the cloud is in another convention.
LabelledCloud sound_cloud(const LabelledCloud& cloud, bool from_camera, CloudFaults& faults);

}  // namespace glisson
