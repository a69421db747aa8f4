// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/error.h"
#include "glisson/guidance/tracker.h"

namespace glisson::guidance {

void TrackerOptions::validate() const {
  const OptionCheck demand("tracker options");
  demand(points >= 10, "points", points, "Give 10 or more");
  demand(forward_backward_px > 0.0, "forward_backward_px", forward_backward_px, "Give a positive number");
  demand(epipolar_px > 0.0, "epipolar_px", epipolar_px, "Give a positive number");
  demand(window_px >= 5 && window_px % 2 == 1, "window_px", window_px, "Give an odd number from 5");
  demand(levels >= 1 && levels <= 6, "levels", levels, "Give a number from 1 to 6");
  demand(minimum_pairs >= 3, "minimum_pairs", minimum_pairs, "Give 3 or more");
  demand(most_masked > 0.0 && most_masked <= 1.0, "most_masked", most_masked,
         "Give a share above 0, at most 1");
  demand(maximum_residual > 0.0, "maximum_residual", maximum_residual, "Give a positive length in metres");
  demand(minimum_consistent_share >= 0.0 && minimum_consistent_share <= 1.0, "minimum_consistent_share",
         minimum_consistent_share, "Give a share from 0 to 1");
  demand(time_step > 0.0, "time_step", time_step, "Give a positive number of seconds");
  demand(steps_per_frame >= 1, "steps_per_frame", steps_per_frame, "Give 1 or more");
  demand(point_stiffness > 0.0, "point_stiffness", point_stiffness, "Give a positive number");
  demand(boundary_young_modulus >= 0.0, "boundary_young_modulus", boundary_young_modulus,
         "Give a number from zero");
  demand(boundary_length > 0.0, "boundary_length", boundary_length, "Give a positive length in metres");
  demand(boundary_tether > 0.0, "boundary_tether", boundary_tether, "Give a positive number");
  materials.validate();
  cloud.validate();
  judge.validate();
  lesions.validate();
}

}  // namespace glisson::guidance
