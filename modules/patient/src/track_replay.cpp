// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/track_replay.h"

#include <cmath>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/geometry/mesh_io.h"

namespace glisson {

TrackReplay::TrackReplay(const std::filesystem::path& track, int nodes, Frames frames)
    : file_(std::filesystem::is_directory(track) ? track / "frames.jsonl" : track),
      folder_(file_.parent_path()),
      frames_(frames),
      nodes_(nodes) {
  OverlayRecord record = read_overlay_record(file_);
  if (record.frames.empty())
    throw InputError(file_.string(), "frames", "there are none",
                     "Give a folder that 'glisson track' filled, or what was written beside a recording");
  for (OverlayLine& line : record.frames) {
    if (frames_ == Frames::of_the_recording && !line.film_frame)
      throw InputError(file_.string(), "frame " + std::to_string(line.number), "is not of a recording",
                       "Give the file NAME.frames.jsonl that was written beside it");
    const int number = frames_ == Frames::of_the_recording ? *line.film_frame : line.number;
    lines_.insert_or_assign(number, std::move(line));
  }
  complete_ = record.complete;
}

void TrackReplay::require_nodes(const OverlayFrame& overlay, const std::string& where) const {
  if (overlay.nodes_in_camera.rows() != nodes_)
    throw InputError(where, "nodes",
                     "there are " + std::to_string(overlay.nodes_in_camera.rows()) + ", the model has " +
                         std::to_string(nodes_),
                     "Give the case whose model was tracked");
}

std::optional<OverlayFrame> TrackReplay::at(int frame, double seconds, double frames_per_second) const {
  const auto found = lines_.find(frame);
  if (found == lines_.end()) return std::nullopt;
  const OverlayLine& line = found->second;
  OverlayFrame overlay = line.overlay;
  const double half_a_frame = 0.5 / frames_per_second;
  if (frames_ == Frames::of_the_source && std::abs(overlay.seconds - seconds) > half_a_frame)
    throw InputError("track", "frame " + std::to_string(frame), "is of another moment than the video's",
                     "Give the track of this video");
  if (overlay.level() == Level::withdrawn) return overlay;
  if (line.nodes_here) {
    require_nodes(overlay, file_.string() + ", frame " + std::to_string(frame));
    return overlay;
  }
  const std::filesystem::path mesh = folder_ / line.mesh;
  if (line.mesh.empty() || mesh.extension() != ".vtu")
    throw InputError(file_.string(), "frame " + std::to_string(frame), "has no mesh of tetrahedra",
                     "Track the case itself: --model CASE");
  const TetFile file = read_tet_file(mesh, line.unit, MeshShape::deformed);
  const std::string shift = "displacement_";  // and the unit in which the mesh was written
  for (const auto& [name, values] : file.point_data)
    if (name.starts_with(shift) && name != shift + unit_code(line.unit))
      throw InputError(
          file_.string(), "frame " + std::to_string(frame) + ", unit",
          std::string("is ") + unit_code(line.unit) + ", and the mesh's is " + name.substr(shift.size()),
          "Give what 'glisson track' wrote");
  overlay.nodes_in_camera = file.mesh.vertices;
  require_nodes(overlay, mesh.string());
  return overlay;
}

}  // namespace glisson
