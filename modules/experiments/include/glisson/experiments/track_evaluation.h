// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"

namespace glisson::experiments {

/// Counts the frames of a track and their times.
class FrameTimes {
 public:
  /// @param frames_per_second of the source: a frame that takes longer is late. @pre positive
  explicit FrameTimes(double frames_per_second);
  void add(const OverlayFrame& overlay);

  int frames() const { return static_cast<int>(milliseconds_.size()); }
  /// `frames`, `frames_late`, and of each level `frames_valid`, `frames_degraded`, `frames_withdrawn`.
  Figures counts() const;
  /// `frame_p50_ms`, `frame_p99_ms`; not a number without frames.
  Figures percentiles() const;

 private:
  double frames_per_second_;
  std::vector<double> milliseconds_;
  int late_ = 0, valid_ = 0, degraded_ = 0;
};

/// Sums up a track: how many frames were followed in time, how far the model moved, and how far it was from
/// the truth where that is known. Lengths in the figures are means over frames unless they say otherwise.
class TrackEvaluation {
 public:
  /// @param model that is tracked; outlives this. @param start where tracking began: the frozen model that a
  ///   track is compared with. @param frames_per_second of the source.
  /// @pre a position in `start` for each node; frames_per_second > 0
  TrackEvaluation(const PatientModel& model, const Registration& start, double frames_per_second);

  /// Counts a frame and its time.
  void add(const OverlayFrame& overlay);
  /// Compares a frame that was added with its truth, camera frame, metres.
  /// @param name of the truth in the error. @return this frame's target_errors() and `tre_frozen_mean_mm`.
  /// @pre overlay.nodes_in_camera is not empty. @throws InputError as target_errors().
  Figures compare(const OverlayFrame& overlay, const Points& true_nodes_in_camera, const std::string& name);
  /// Where the nodes truly were when tracking began: from the next comparison on, errors() tells of motion
  /// too. @pre as many as the model has nodes; nothing was compared yet.
  void set_true_start(const Points& true_nodes_in_camera);

  const FrameTimes& times() const { return times_; }
  int compared() const { return compared_; }
  /// `displacement_mean_mm` of the nodes from where the rigid part of the start puts them, over the frames
  /// with a position; not a number without.
  Figures displacement() const;
  /// Over the frames compared: target_errors() (of its maxima the largest) and `tre_frozen_mean_mm`; with a
  /// true start `motion_mean_mm` since then (a frozen model misses it all) and `motion_error_mean_mm`, what
  /// tracking missed of it, whatever error it started with. Empty when none was compared.
  Figures errors() const;

 private:
  const PatientModel& model_;
  Points frozen_, rigid_, true_start_;
  FrameTimes times_;
  int placed_ = 0, compared_ = 0;
  double displacement_ = 0.0;  ///< metres, summed over the frames placed
  Figures sums_;               ///< over the frames compared; of maxima, the largest
};

}  // namespace glisson::experiments
