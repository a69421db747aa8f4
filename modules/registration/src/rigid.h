// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/registration/register.h"

namespace glisson::registration {

/// Where the model is before it is bent: CT frame to the left camera's, metres.
struct RigidStart {
  CameraFromCt camera_from_ct;
  double residual = 0.0;  ///< metres: trimmed mean distance of the cloud from the model
  /// Other poses that fit well, 10 mm and more from the start and from each other, the better first, four at
  /// most (and the one that was set by hand).
  std::vector<CameraFromCt> alternatives;
  std::vector<std::string> doubts;  ///< codes with values, see align_rigid
};
/// Rigid alignment from the labelled features, robust to a partial view and a wrong start: seeded starts,
/// trimmed label-restricted ICP, the better ones refined and judged along the camera's rays too. The camera
/// is at the origin of the cloud's frame. Doubts: few_margin_points, rigid_residual_large,
/// rigid_ambiguous (another pose, 20 mm away on average and more, fits nearly as well).
/// @throws InputError fewer than 10 points, not finite, options out of range.
Cancellable<RigidStart> align_rigid(const PatientModel& model, const LabelledCloud& cloud,
                                    const RigidOptions& options, const RunContext& context);
/// The same from about a pose that a person has set: starts are drawn around it (15 degrees and 10 mm about
/// each axis, one deviation). That pose itself is one more alternative, should the cloud draw the model
/// elsewhere.
Cancellable<RigidStart> align_rigid_near(const PatientModel& model, const LabelledCloud& cloud,
                                         const CameraFromCt& near, const RigidOptions& options,
                                         const RunContext& context);

}  // namespace glisson::registration
