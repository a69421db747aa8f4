// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>

#include "cli.h"
#include "glisson/patient/overlay_record.h"
#include "glisson/patient/picture.h"

namespace glisson::app {

/// What 'glisson track' wrote of a video, to be drawn again instead of followed again.
class TrackReplay {
 public:
  /// @param folder of the track. @param nodes of the model that is drawn.
  /// @throws FileError, InputError.
  TrackReplay(std::filesystem::path folder, int nodes);
  /// What was known in a frame; empty: it was not tracked. @throws FileError, InputError the mesh beside the
  /// record is not of this model.
  std::optional<OverlayFrame> at(int frame) const;
  int first() const { return lines_.begin()->first; }
  bool is_complete() const { return complete_; }

 private:
  std::filesystem::path folder_;
  std::map<int, OverlayLine> lines_;  ///< by number
  bool complete_ = false;
  int nodes_;
};

/// Hands over each tracked frame of the case's video with what was known of it.
/// @param last number of the last frame, or -1 for all.
/// @throws Error, Interrupted; InputError where the track's time of a frame is not the video's.
void replay_video(Session& session, const TrackReplay& replay, int last,
                  const std::function<void(const StereoFrame&, const OverlayFrame&)>& frame);

}  // namespace glisson::app
