// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "glisson/geometry/rigid.h"
#include "stereo_follower.h"

namespace glisson::guidance {

/// The rigid motion that most points share: from where the model has them to where they were seen, in their
/// information (weak along the line of sight, where the depth is uncertain), by Cauchy's weights
///     w = 1 / (1 + (r / c)^2),   c = 1.5 mm at least, else 2.385 scaled median residuals,
/// from the best of several starts. So a tool that holds many points, or a lobe that moves on its own, does
/// not turn the scope. The same points give the same motion.
/// @param gaps measured less modelled places, metres, one a point.
RigidMotion scope_motion(const std::vector<FollowedPoint>& points, const std::vector<Eigen::Vector3d>& gaps);

}  // namespace glisson::guidance
