// SPDX-License-Identifier: GPL-3.0-or-later
#include "track_replay.h"

#include <cmath>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/engine/parts/video.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/stereo/picture_io.h"

namespace glisson::app {

TrackReplay::TrackReplay(std::filesystem::path folder, int nodes)
    : folder_(std::move(folder)), nodes_(nodes) {
  OverlayRecord record = read_overlay_record(folder_ / "frames.jsonl");
  if (record.frames.empty())
    throw InputError((folder_ / "frames.jsonl").string(), "frames", "there are none",
                     "Give a folder that 'glisson track' filled");
  for (OverlayLine& line : record.frames) lines_.insert_or_assign(line.number, std::move(line));
  complete_ = record.complete;
}

std::optional<OverlayFrame> TrackReplay::at(int frame) const {
  const auto found = lines_.find(frame);
  if (found == lines_.end()) return std::nullopt;
  const OverlayLine& line = found->second;
  OverlayFrame overlay = line.overlay;
  if (overlay.level() == Level::withdrawn) return overlay;
  const std::filesystem::path mesh = folder_ / line.mesh;
  if (line.mesh.empty() || mesh.extension() != ".vtu")
    throw InputError((folder_ / "frames.jsonl").string(), "frame " + std::to_string(frame),
                     "has no mesh of tetrahedra", "Track the case itself: --model CASE");
  overlay.nodes_in_camera = read_tet_mesh(mesh, line.unit).vertices;
  if (overlay.nodes_in_camera.rows() != nodes_)
    throw InputError(mesh.string(), "nodes",
                     "there are " + std::to_string(overlay.nodes_in_camera.rows()) +
                         ", the case's model has " + std::to_string(nodes_),
                     "Give the case whose model was tracked");
  return overlay;
}

void replay_video(Session& session, const TrackReplay& replay, int last,
                  const std::function<void(const StereoFrame&, const OverlayFrame&)>& frame) {
  session.need({part::video});
  const engine::VideoSource& source = *session.state()[part::video];
  stereo::StereoVideo video(source.left, source.right);
  const double half_a_frame = 0.5 / video.frames_per_second();
  for (StereoFrame next; video.read(next);) {
    if (session.context().cancelled()) throw Interrupted();
    if (const auto overlay = replay.at(next.index)) {
      if (std::abs(overlay->seconds - next.seconds) > half_a_frame)
        throw InputError("track", "frame " + std::to_string(next.index),
                         "is of another moment than the video's", "Give the track of this video");
      frame(next, *overlay);
    }
    if (last >= 0 && next.index >= last) break;
  }
}

}  // namespace glisson::app
