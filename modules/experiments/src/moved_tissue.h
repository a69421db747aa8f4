// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/patient/patient_model.h"
#include "live_faults.h"
#include "real_pairs.h"

namespace glisson::experiments {

/// A real pair set in motion: the surface that it shows is moved in a known way, and each view is drawn anew
/// from its own picture. So texture, highlights and blur are a real laparoscope's and the truth is known; but
/// highlights and light move with the tissue, which they do not in a patient, and nothing comes in front.
struct MovedTissue {
  PatientModel model;  ///< a slab of 24 mm below the surface, where it is in the first frame
  Points targets;      ///< in the slab, 5 to 20 mm deep, first frame
  /// By a laparoscope that stands: tissue that breathes by 5 mm and is pressed in by 4.
  Film standing;
  /// The same by one in a hand, which turns by up to 10 degrees a second.
  Film held;
  std::vector<Points> standing_targets, held_targets;  ///< where they truly are in each frame
};

/// @param seed of the noise that each frame has of its own (two grey levels). Positions are metres in the
///   left camera's frame. Empty: cancelled. @throws InputError the pair shows no surface.
Cancellable<MovedTissue> set_in_motion(const RealPair& pair, int frames, std::uint64_t seed,
                                       const RunContext& context);

}  // namespace glisson::experiments
