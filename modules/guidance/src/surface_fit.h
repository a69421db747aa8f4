// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "glisson/registration/moving_surface.h"

namespace glisson::guidance {

/// What stereo sees along one ray. Left camera's frame, metres.
struct SeenPlace {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  double sigma = 1e-3;  ///< along the ray
  int region = 0;       ///< part of the picture; errors of one part go together
};

/// The organ is predicted at `at`, and stereo looks past it there; `to` is the nearest place in the picture
/// where it does see the organ. Left camera's frame, metres.
struct LookedThrough {
  Eigen::Vector3d at = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
  int region = 0;
};

/// The rigid motion of the organ that would reconcile it with stereo.
struct SurfacePull {
  double pull = 0.0;   ///< metres, rms over the organ
  double sigma = 0.0;  ///< metres, standard deviation of that motion: what stereo cannot tell
};

/// Metres: how far a right overlay may be off the surface besides stereo's own error. Registration and the
/// coarse mechanics leave that much.
inline constexpr double kModelSigma = 1.5e-3;

/// Looks for it from two starts: where the organ is predicted, and where the seen surface alone draws it to.
/// The more probable place counts, or the farther one where both are plausible.
/// @param normals of `surface`.
SurfacePull fit_to_seen(const registration::MovingSurface& surface, registration::NormalMemo& normals,
                        const std::vector<SeenPlace>& seen, const std::vector<LookedThrough>& through);

}  // namespace glisson::guidance
