// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/core/frames.h"
#include "glisson/geometry/rigid.h"

namespace glisson::registration {

/// How far the cloud is believed when the most probable shape is looked for.
struct ShapeFitOptions {
  /// Standard deviations, metres: of a surface point across the surface (the reconstruction's noise and the
  /// segmentation's), of a margin point, of the notch as a whole.
  double sigma_surface = 3e-3, sigma_margin = 6e-3, sigma_notch = 3e-3;
  /// Independent information in what the reference density's one point stands for: neighbouring points share
  /// the error of the model's surface, they do not average it away. In (0, 1].
  double information = 0.2;
  int max_iterations = 80;
  bool from_cavity = false;  ///< as RigidOptions::from_cavity: ends that say otherwise are dropped for others
  int threads = 2;           ///< 1 or 2, for several fits: the same bits
  /// @throws InputError naming the option.
  void validate() const;
};

/// How each look of a joined cloud (looks.h) is moved before it agrees with the first, which stays. Empty: as
/// the cloud has them.
using LookMotions = std::vector<Rigid<CameraFrame, CameraFrame>>;

}  // namespace glisson::registration
