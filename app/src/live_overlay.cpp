// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_overlay.h"

#include "glisson/core/output_file.h"
#include "glisson/core/stopwatch.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/parts/video.h"
#include "glisson/ui/common/overlay_status.h"

namespace glisson::app {
namespace {

const engine::CaseState& drawable(const engine::CaseState& state) {
  engine::require_parts(state, {part::model, part::rig});
  return state;
}

}  // namespace

OverlayDrawer::OverlayDrawer(const engine::CaseState& state, const scene::OverlayStyle& style)
    : camera_(drawable(state)[part::rig]->left),
      drawable_(scene::make_drawable(
          std::make_shared<const PatientModel>(engine::effective_model(drawable(state))))),
      painter_(drawable_, drawable_->model->landmarks.anterior_margin, camera_, style),
      status_(ui::overlay_status(state)) {}

Picture OverlayDrawer::draw(const StereoFrame& frame, const OverlayFrame& overlay,
                            const scene::OverlayInterest& interest) {
  return painter_.paint(frame.left, overlay, status_, interest);
}

std::optional<guidance::SurfacePlace> OverlayDrawer::place_at(const Eigen::Vector2d& pixel,
                                                              const OverlayFrame& overlay) const {
  return scene::place_at(*drawable_, camera_, overlay, pixel);
}

OverlayRecorder::OverlayRecorder(const engine::CaseState& state, const std::filesystem::path& path,
                                 double frames_per_second, const scene::OverlayStyle& style,
                                 const scene::OverlayInterest& interest, bool is_paced)
    : path_(path),
      unfinished_(path.parent_path() / (path.stem().string() + ".incomplete" + path.extension().string())),
      drawer_(state, style),
      interest_(interest),
      writer_(unfinished_, state[part::rig]->left.width, state[part::rig]->left.height, frames_per_second) {
  if (is_paced) pace_.emplace(frames_per_second);
}

double OverlayRecorder::add(const StereoFrame& frame, const OverlayFrame& overlay) {
  const Stopwatch watch;
  const Picture drawn = drawer_.draw(frame, overlay, interest_);
  const double milliseconds = watch.milliseconds();
  writer_.add(drawn, pace_ ? pace_->next(overlay.seconds) : stereo::FilmPace::Place());
  return milliseconds;
}

void OverlayRecorder::finish(bool whole) {
  writer_.close();
  if (whole) std::filesystem::rename(unfinished_, place_for_file(path_));
}

void OverlayRecorder::keep() { writer_.keep(); }

std::function<Picture(const engine::CaseState&, const StereoFrame&, const OverlayFrame&)> overlay_hook() {
  struct Kept {
    std::shared_ptr<const model::BuiltModel> model;
    std::unique_ptr<OverlayDrawer> drawer;
  };
  return [kept = std::make_shared<Kept>()](const engine::CaseState& state, const StereoFrame& frame,
                                           const OverlayFrame& overlay) {
    if (kept->model != state[part::model]) {
      kept->drawer = std::make_unique<OverlayDrawer>(state);
      kept->model = state[part::model];
    }
    return kept->drawer->draw(frame, overlay);
  };
}

void follow_video(Session& session, const guidance::TrackerOptions& options, int last,
                  const guidance::FrameTaker& frame) {
  engine::StartTracking start;
  start.options = options;
  start.source = engine::StartTracking::Source::video;
  session.post(start);
  const guidance::FrameSpan span{session.state()[part::frame]->frame.index, last};
  const engine::VideoSource& source = *session.state()[part::video];
  stereo::StereoVideo video(source.left, source.right);
  const int frames = video.frame_count();
  const auto followed = [&](const StereoFrame& next) {
    return session.follow(next, span.done_with(next.index, frames));
  };
  guidance::each_frame(video, span, followed, frame);
}

void replay_video(Session& session, const TrackReplay& replay, const engine::VideoSource& source, int last,
                  const guidance::FrameTaker& frame) {
  stereo::StereoVideo video(source.left, source.right);
  const auto known = [&](const StereoFrame& next) {
    if (session.context().cancelled()) throw Interrupted();
    return replay.at(next.index, next.seconds, video.frames_per_second());
  };
  guidance::each_frame(video, {0, last}, known, frame);
}

}  // namespace glisson::app
