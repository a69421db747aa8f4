// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/patient/registration.h"
#include "live_stage.h"

namespace glisson::experiments {

/// One frame of a run, judged with the truth at hand.
struct JudgedFrame {
  int frame = 0;
  double error = 0.0;   ///< metres, largest over the targets
  double frozen = 0.0;  ///< likewise, of a model that stays where it was registered
  bool faulty = false;
  OverlayFrame overlay;
  double strength = 0.0;              ///< guidance::Tracker::evidence_strength()
  std::vector<double> lesion_errors;  ///< metres, one a verdict of the overlay
  /// Without evidence of its own the tracker would have shown it.
  bool shown_before() const;
  bool is_valid() const { return overlay.validity == Validity::valid; }
};

/// Whether the stage has what the fault shows.
bool can_run(const LiveStage& stage, const LiveFault& fault);
/// @param onset the frame from which the fault is there, where it is one of the frames. @pre can_run().
std::vector<JudgedFrame> run_live(const LiveStage& stage, const LiveFault& fault, int onset);

/// Lines of live.csv and lesions.csv, with their newlines.
extern const char* const kFrameHeads;
extern const char* const kLesionHeads;
std::string frame_line(const std::string& stage, const std::string& fault, const JudgedFrame& judged);
std::string lesion_lines(const std::string& stage, const std::string& fault, const JudgedFrame& judged);

}  // namespace glisson::experiments
