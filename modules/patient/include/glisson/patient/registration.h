// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/core/termination.h"
#include "glisson/geometry/mesh.h"
#include "glisson/geometry/rigid.h"

namespace glisson {

/// A model brought to what the camera sees.
struct Registration {
  /// The rigid part: where the undeformed model was put before it was deformed.
  CameraFromCt camera_from_ct;
  /// Every node of the model's mesh, camera frame, metres, in the model's order.
  Points nodes_in_camera;
  Termination termination = Termination::step_limit;
  int plateaus = 0, steps = 0;
  /// Mean distance of the cloud's points to the registered surface, metres. A residual, not an accuracy.
  double residual = 0.0;
  /// Share of the model's surface that the cloud shows.
  double seen_share = 0.0;
  /// What the method cannot vouch for; codes, not prose ("few_margin_points", "inverted_elements"). Empty:
  /// none.
  std::vector<std::string> doubts;
};

/// Why no overlay may be drawn, or that it may.
enum class Validity {
  valid,
  not_started,
  too_few_points,
  inconsistent_motion,
  residual_too_large,
  mechanics_failed,
  stale
};
const char* validity_code(Validity validity);

/// The model at one frame of the video. Only a valid one is drawn as current.
struct OverlayFrame {
  int index = 0;
  double seconds = 0.0;
  Validity validity = Validity::not_started;
  bool doubtful = false;   ///< the registration that this began with carries doubts: drawn, and said so
  Points nodes_in_camera;  ///< as Registration::nodes_in_camera
  int tracked_left = 0, tracked_right = 0, pairs = 0;
  double residual = 0.0;      ///< metres, mean over the pairs
  double milliseconds = 0.0;  ///< tracking, correspondence and mechanics of this frame
};

}  // namespace glisson
