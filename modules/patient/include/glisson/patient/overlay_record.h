// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glisson/core/units.h"
#include "glisson/patient/registration.h"

/// @file
/// frames.jsonl: what was known of the overlay in each frame of a track, a line of JSON a frame. With the
/// meshes beside it the same film can be drawn again.

namespace glisson {

/// One frame. The line's lengths are in its unit, squares of lengths in its square.
struct OverlayLine {
  int number = 0;
  LengthUnit unit = LengthUnit::millimetre;
  std::string mesh;  ///< file beside frames.jsonl with the nodes; empty: there are none
  /// The rigid motion that comes nearest to where the nodes are, metres.
  std::optional<Eigen::Matrix4d> camera_from_model;
  /// Without the nodes, which are the mesh's. Figures of the tracker (pairs, evidence) are not in the line.
  OverlayFrame overlay;
};

/// Without a newline.
std::string overlay_line(const OverlayLine& line);
/// The line that says how the track ended.
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

struct OverlayRecord {
  std::vector<OverlayLine> frames;
  bool complete = false;  ///< false: the track was cut short, or the file was
};

/// @throws FileError, InputError naming file and line.
OverlayRecord read_overlay_record(const std::filesystem::path& path);

}  // namespace glisson
