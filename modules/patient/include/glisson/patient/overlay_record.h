// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glisson/core/units.h"
#include "glisson/patient/registration.h"

/// @file
/// frames.jsonl: what was known of the overlay in each frame of a track, or of a recording of the live view,
/// a line of JSON a frame. With the meshes beside it, or the nodes in it, the same film can be drawn again.

namespace glisson {

/// One frame. The line's lengths are in its unit, squares of lengths in its square.
struct OverlayLine {
  int number = 0;
  LengthUnit unit = LengthUnit::millimetre;
  std::string mesh;         ///< file beside frames.jsonl with the nodes; empty: there is none
  bool nodes_here = false;  ///< the overlay's nodes are in the line itself, to 0.1 micrometres
  /// The rigid motion that comes nearest to where the nodes are, metres.
  std::optional<Eigen::Matrix4d> camera_from_model;
  /// With the evidence behind its level. Without the nodes where they are the mesh's.
  OverlayFrame overlay;
  std::string remedy;  ///< what to do about the reason, in words for people; empty: nothing is said
  /// Of a recording: the number of its own frame, and seconds from the camera to the drawn picture.
  std::optional<int> film_frame;
  std::optional<double> age;
};

/// The rigid motion that comes nearest to where an overlay's nodes are; empty: it has none.
/// @param at_rest the model's nodes, as many.
std::optional<Eigen::Matrix4d> pose_of(const PointsIn<CtFrame>& at_rest, const OverlayFrame& overlay);

/// Without a newline.
std::string overlay_line(const OverlayLine& line);
/// The line that says how the track ended. @param frames that have a line.
std::string overlay_record_end(bool complete, int frames);

/// The organ was registered again after a frame.
struct AgainLine {
  int frame = 0;
  double seconds = 0.0;
  bool is_taken = false;               ///< false: the former registration stayed
  double former_gap = 0.0, gap = 0.0;  ///< metres: from tissue that neither had used, before and after
  double moved = 0.0;                  ///< metres, mean way of the nodes
};
/// For people and programs that look on; what reads the film again leaves it out. Without a newline.
std::string again_line(const AgainLine& line);

/// What a frames.jsonl holds, in the file's order.
struct OverlayRecord {
  std::vector<OverlayLine> frames;
  bool complete = false;  ///< false: the track was cut short, or the file was
};

/// @throws FileError, InputError naming file and line.
OverlayRecord read_overlay_record(const std::filesystem::path& path);

}  // namespace glisson
