// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "glisson/guidance/lesion_judge.h"
#include "live_faults.h"
#include "live_proof.h"
#include "live_roc.h"
#include "live_run.h"

namespace glisson::experiments {

/// Counts over the frames of one fault.
struct FaultTally {
  int far = 0, far_hidden = 0, far_hidden_before = 0;
  int near = 0, near_valid = 0, near_sound = 0, near_sound_valid = 0;
  double error_sum = 0.0;  ///< metres, over all frames
  int frames = 0;
  /// Metres, over the frames that are valid.
  double shown_sum = 0.0, frozen_sum = 0.0;
  int shown_frames = 0;
  std::map<std::string, int> shown;  ///< frames, by what is said of them
  /// Thirtieths of a second from where the picture is good again to a valid overlay under 3 mm.
  int returned = -1;
  int latest = -1;  ///< likewise the longest run of frames over 10 mm that are valid; -1: none is over
  std::vector<double> milliseconds;

  void add(const std::vector<JudgedFrame>& run);
  /// @param good_from the frame from which the picture shows the organ well again; -1: never.
  void add_return(const std::vector<JudgedFrame>& run, int good_from);
  void merge(const FaultTally& other);
  std::string most_shown() const;
};

/// Verdicts of single lesions against where these truly are.
struct LesionTally {
  int far = 0, far_hidden = 0, near_sound = 0, near_sound_valid = 0;  ///< over 10 mm, under 3 mm
  int drawn = 0, inside = 0;  ///< drawn at all; of these, truly no farther off than their 95 % region reaches
  Roc roc;

  void add(const JudgedFrame& judged, bool is_sound);
};

/// Faults that no stage could show.
class Untried {
 public:
  /// Whether the stage has what the fault shows; remembers it.
  bool can_try(const LiveStage& stage, const LiveFault& fault);
  /// In their order.
  std::vector<std::string> names() const;

 private:
  std::vector<std::pair<std::string, bool>> tried_;
};

/// All runs on one kind of stage.
class LiveTally {
 public:
  void add(const LiveFault& fault, const std::vector<JudgedFrame>& run);
  /// Into the proof's table and figures. @param prefix of the figures' keys.
  void sum_up(const std::string& title, const std::string& prefix, LiveProof& proof) const;

 private:
  FaultTally all() const;
  void tell_faults(const std::string& title, LiveProof& proof) const;
  void tell_lesions(const std::string& title, const std::string& prefix, LiveProof& proof) const;

  std::vector<std::string> names_;  ///< of the faults, in their order
  std::map<std::string, FaultTally> tallies_;
  /// Faults whose start is right, so that a frozen model is one to be compared with.
  std::vector<std::string> comparable_;
  Roc roc_;
  LesionTally lesions_;
};

}  // namespace glisson::experiments
