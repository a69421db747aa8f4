// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/patient/patient_model.h"
#include "live_faults.h"

namespace glisson::experiments {

/// What was filmed, and where the lesions' centres truly were in each frame: left camera's frame, metres.
struct Filmed {
  Film film;
  std::vector<Points> targets;
};

/// An organ filmed by a laparoscope that stands and by one in a hand, with the model that is to follow.
struct LiveStage {
  PatientModel model;
  StereoRig rig;
  Filmed standing, held;
  Filmed lifted;  ///< a part of the organ is lifted by 30 mm in the second second; empty: not filmed
  Filmed cut;     ///< a cut gapes by 15 mm in the second second; empty: not filmed
  Filmed fast;    ///< by one in a fast hand
  Filmed tool_lifts, tool_presses;  ///< a tool takes a place of the organ along; empty: not filmed
  Filmed other;                     ///< another patient's, by the same laparoscope; empty: none
  Points start;                     ///< the model's nodes where they truly are in the first frame
  Points targets_in_model;          ///< the lesions' centres, in the model's frame
  std::vector<Label> lesions;       ///< of the targets; empty: the model has no lesions there
};

/// A synthetic patient in the theatre. Empty: cancelled.
Cancellable<LiveStage> theatre_stage(std::uint64_t seed, int frames, const RunContext& context);

}  // namespace glisson::experiments
