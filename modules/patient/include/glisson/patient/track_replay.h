// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "glisson/patient/overlay_record.h"

namespace glisson {

/// What 'glisson track' wrote of a video, or the window beside a recording, to be drawn again instead of
/// followed again.
class TrackReplay {
 public:
  /// Whose frames are asked for: the video's that was followed, or the recording's own.
  enum class Frames { of_the_source, of_the_recording };
  /// @param track folder of a track, with frames.jsonl, or such a file. @param nodes of the model that is
  ///   drawn. @throws FileError, InputError.
  TrackReplay(const std::filesystem::path& track, int nodes, Frames frames = Frames::of_the_source);
  /// What was known in a frame, nodes included (camera frame, metres); empty: it was not tracked.
  /// @param seconds when the video shows it; a recording's own frames are told by their number alone.
  /// @param frames_per_second of the video.
  /// @throws FileError; InputError it was tracked at another moment, or the mesh beside the record is not of
  /// this model.
  std::optional<OverlayFrame> at(int frame, double seconds, double frames_per_second) const;
  /// Number of the first frame, of the source.
  int first() const { return lines_.begin()->second.number; }
  bool is_complete() const { return complete_; }
  /// It was written beside a recording: where a picture is not in it, the one before stood on the screen.
  bool is_recording() const { return lines_.begin()->second.film_frame.has_value(); }

 private:
  /// @throws InputError they are of another model.
  void require_nodes(const OverlayFrame& overlay, const std::string& where) const;

  std::filesystem::path file_, folder_;
  Frames frames_;
  std::map<int, OverlayLine> lines_;  ///< by number
  bool complete_ = false;
  int nodes_;
};

}  // namespace glisson
