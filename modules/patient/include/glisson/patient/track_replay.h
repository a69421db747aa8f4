// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>

#include "glisson/patient/overlay_record.h"

namespace glisson {

/// What 'glisson track' wrote of a video, to be drawn again instead of followed again.
class TrackReplay {
 public:
  /// @param folder of the track, with frames.jsonl. @param nodes of the model that is drawn.
  /// @throws FileError, InputError.
  TrackReplay(std::filesystem::path folder, int nodes);
  /// What was known in a frame, nodes included (camera frame, metres); empty: it was not tracked.
  /// @param seconds when the video shows it. @param frames_per_second of the video.
  /// @throws FileError; InputError it was tracked at another moment, or the mesh beside the record is not of
  /// this model.
  std::optional<OverlayFrame> at(int frame, double seconds, double frames_per_second) const;
  int first() const { return lines_.begin()->first; }
  bool is_complete() const { return complete_; }

 private:
  std::filesystem::path folder_;
  std::map<int, OverlayLine> lines_;  ///< by number
  bool complete_ = false;
  int nodes_;
};

}  // namespace glisson
