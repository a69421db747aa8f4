// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/core/run_context.h"
#include "glisson/fem/composite_model.h"
#include "glisson/geometry/camera.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"

namespace glisson::guidance {

struct TrackerOptions {
  int points = 200;                  ///< followed per camera
  double forward_backward_px = 1.0;  ///< gate on the disagreement
  int minimum_pairs = 30;            ///< fewer: no overlay
  double maximum_residual = 5e-3;    ///< m; more: no overlay
  double time_step = 1.0 / 30.0;
  int steps_per_frame = 1;
  fem::CompositeOptions materials;
  double boundary_young_modulus = 20e6;  ///< vena cava, tree entrances
  std::vector<int> fixed_nodes;
  void validate() const;
};

/// Temporal registration (paper 2.2.3): points on the organ followed by pyramidal Lucas-Kanade forward and
/// backward in both images, triangulated, pulling at the model; one registration a frame. Not thread-safe.
class Tracker {
 public:
  Tracker(const PatientModel& model, const Registration& start, const TrackerOptions& options);
  ~Tracker();

  /// Gives the video its camera and its first frame: the one that `start` was registered to.
  /// @param mask optional, non-zero where tissue may be followed.
  void begin(const StereoRig& rig, const StereoFrame& first, const Picture& mask);
  /// The next frame. Always returns; validity says whether it may be shown.
  OverlayFrame follow(const StereoFrame& frame);
  /// Registration to a cloud instead of pictures (no correspondences in time are assumed).
  OverlayFrame follow(const LabelledCloud& cloud, int index, double seconds, int steps);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::guidance
