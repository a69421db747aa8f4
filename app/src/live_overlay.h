// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "cli.h"
#include "glisson/engine/parts/video.h"
#include "glisson/guidance/each_frame.h"
#include "glisson/guidance/tracker.h"
#include "glisson/patient/track_replay.h"
#include "glisson/stereo/paced_writer.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/scene/overlay_painter.h"

/// @file
/// Follows the case's video and draws what was found: shared by render, overlay, demo and soak.

namespace glisson::app {

/// Draws a case's overlay into its laparoscope's left pictures.
class OverlayDrawer {
 public:
  /// @throws InputError when the case has no model or calibration.
  explicit OverlayDrawer(const engine::CaseState& state, const scene::OverlayStyle& style = {});
  Picture draw(const StereoFrame& frame, const OverlayFrame& overlay,
               const scene::OverlayInterest& interest = {});
  void set_style(const scene::OverlayStyle& style) { painter_.set_style(style); }
  /// Of the chosen lesion in the picture drawn last; empty: it was not shown.
  const std::optional<guidance::LesionMeasures>& measures() const { return painter_.measures(); }
  /// The place of the organ's surface at a pixel of the left picture; empty: there is none.
  std::optional<guidance::SurfacePlace> place_at(const Eigen::Vector2d& pixel,
                                                 const OverlayFrame& overlay) const;

 private:
  Camera camera_;
  std::shared_ptr<const scene::DrawableModel> drawable_;
  scene::OverlayPainter painter_;
  scene::OverlayStatus status_;
};

/// Records drawn frames as a video of the left camera, under another name ("a.incomplete.mkv") until it is
/// whole. Without finish() or keep() nothing remains.
class OverlayRecorder {
 public:
  /// @param is_paced each frame stands for its own moment, and where one is missing the one before stays;
  /// else
  ///   they follow one another.
  OverlayRecorder(const engine::CaseState& state, const std::filesystem::path& path, double frames_per_second,
                  const scene::OverlayStyle& style = {}, const scene::OverlayInterest& interest = {},
                  bool is_paced = false);
  /// @return milliseconds that drawing took.
  double add(const StereoFrame& frame, const OverlayFrame& overlay);
  /// @param whole false: what was cut short stays under the other name. @throws FileError
  void finish(bool whole);
  /// What an error has cut short stays as far as it plays.
  void keep();
  const std::filesystem::path& unfinished() const { return unfinished_; }

 private:
  std::filesystem::path path_, unfinished_;
  OverlayDrawer drawer_;
  scene::OverlayInterest interest_;
  stereo::PacedWriter writer_;
  std::optional<stereo::FilmPace> pace_;  ///< empty: frames follow one another
};

/// Draws a frame of a case. Makes the drawer when the first frame comes, and again only for another model.
std::function<Picture(const engine::CaseState&, const StereoFrame&, const OverlayFrame&)> overlay_hook();

/// Follows the case's video from its registered frame and hands each frame over; every frame is processed.
/// @param last number of the last frame, or -1 for all. @throws Error, Interrupted.
void follow_video(Session& session, const guidance::TrackerOptions& options, int last,
                  const guidance::FrameTaker& frame);
/// Hands over each tracked frame of a video with what was known of it.
/// @param video the source of the frames. @param last number of the last frame, or -1 for all.
/// @throws Error, Interrupted; InputError where the track's time of a frame is not the video's.
void replay_video(Session& session, const TrackReplay& replay, const engine::VideoSource& video, int last,
                  const guidance::FrameTaker& frame);

}  // namespace glisson::app
