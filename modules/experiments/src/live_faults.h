// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/patient/picture.h"

namespace glisson::experiments {

/// The frames of a run without a fault.
using Film = std::vector<StereoFrame>;

/// Something that goes wrong.
struct LiveFault {
  std::string name;
  /// Where the organ is believed to be at the start, of where it truly is: a turn about its middle, then a
  /// shift. Camera's frame, metres.
  Eigen::Matrix3d start_turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d start_shift = Eigen::Vector3d::Zero();
  /// Metres by which the part of the organ about a target that is seen lies nearer to the lens than the start
  /// has it.
  double start_lift = 0.0;
  /// Metres a frame by which what the program takes for registered creeps away.
  Eigen::Vector3d drift = Eigen::Vector3d::Zero();
  /// What the laparoscope shows at frame k instead of film[k]; empty: film[k].
  std::function<StereoFrame(const Film& film, int k)> show;
  /// The calibration that the program is given instead of the true one; empty: the true one.
  std::function<StereoRig(const StereoRig&)> calibration;
  /// The film is another one: of a laparoscope in a hand, of an organ that is lifted or cut, of another
  /// patient, of a laparoscope in a fast hand, of an organ that a tool takes along.
  bool scope_moves = false, is_lifted = false, is_cut = false, other_patient = false;
  bool scope_is_fast = false, tool_lifts = false, tool_presses = false;
  bool is_mirrored = false;  ///< what is shown is the organ's mirror image: any overlay on it is wrong
  bool is_sound = false;     ///< not a fault: a right overlay is to stay
  int every = 1;             ///< only each second (third ...) frame arrives
  /// From this frame on the laparoscope is in a hand, elsewhere: the film is the other one. -1: never.
  int elsewhere_from = -1;
  /// From this frame on the left picture shows what the right camera sees. -1: never.
  int swapped_from = -1;
};

/// Those without a fault in which laparoscope or organ are moved by hands, the first of them none.
std::vector<LiveFault> handled_films();
/// All of the table, the first of them none.
/// @param onset the frame from which `show` differs; ramps end at `last`.
std::vector<LiveFault> live_faults(const StereoRig& rig, int onset, int last, std::uint64_t seed);

}  // namespace glisson::experiments
