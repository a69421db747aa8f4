// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/track_replay.h"

#include <cmath>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/geometry/mesh_io.h"

namespace glisson {

TrackReplay::TrackReplay(std::filesystem::path folder, int nodes)
    : folder_(std::move(folder)), nodes_(nodes) {
  OverlayRecord record = read_overlay_record(folder_ / "frames.jsonl");
  if (record.frames.empty())
    throw InputError((folder_ / "frames.jsonl").string(), "frames", "there are none",
                     "Give a folder that 'glisson track' filled");
  for (OverlayLine& line : record.frames) lines_.insert_or_assign(line.number, std::move(line));
  complete_ = record.complete;
}

std::optional<OverlayFrame> TrackReplay::at(int frame, double seconds, double frames_per_second) const {
  const auto found = lines_.find(frame);
  if (found == lines_.end()) return std::nullopt;
  const OverlayLine& line = found->second;
  OverlayFrame overlay = line.overlay;
  const double half_a_frame = 0.5 / frames_per_second;
  if (std::abs(overlay.seconds - seconds) > half_a_frame)
    throw InputError("track", "frame " + std::to_string(frame), "is of another moment than the video's",
                     "Give the track of this video");
  if (overlay.level() == Level::withdrawn) return overlay;
  const std::filesystem::path mesh = folder_ / line.mesh;
  if (line.mesh.empty() || mesh.extension() != ".vtu")
    throw InputError((folder_ / "frames.jsonl").string(), "frame " + std::to_string(frame),
                     "has no mesh of tetrahedra", "Track the case itself: --model CASE");
  const TetFile file = read_tet_file(mesh, line.unit);
  const std::string shift = "displacement_";  // and the unit in which the mesh was written
  for (const auto& [name, values] : file.point_data)
    if (name.starts_with(shift) && name != shift + unit_code(line.unit))
      throw InputError(
          (folder_ / "frames.jsonl").string(), "frame " + std::to_string(frame) + ", unit",
          std::string("is ") + unit_code(line.unit) + ", and the mesh's is " + name.substr(shift.size()),
          "Give what 'glisson track' wrote");
  overlay.nodes_in_camera = file.mesh.vertices;
  if (overlay.nodes_in_camera.rows() != nodes_)
    throw InputError(mesh.string(), "nodes",
                     "there are " + std::to_string(overlay.nodes_in_camera.rows()) + ", the model has " +
                         std::to_string(nodes_),
                     "Give the case whose model was tracked");
  return overlay;
}

}  // namespace glisson
