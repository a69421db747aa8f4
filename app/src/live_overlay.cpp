// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_overlay.h"

#include <chrono>

#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/parts/video.h"

namespace glisson::app {
namespace {

const engine::CaseState& drawable(const engine::CaseState& state) {
  engine::require_parts(state, {part::model, part::rig});
  return state;
}

}  // namespace

OverlayDrawer::OverlayDrawer(const engine::CaseState& state, const scene::OverlayStyle& style)
    : camera_(state[part::rig]->left),
      drawable_(scene::make_drawable(
          std::make_shared<const PatientModel>(engine::effective_model(drawable(state))))),
      painter_(drawable_, drawable_->model->landmarks.anterior_margin, camera_, style),
      model_unchecked_(!engine::is_model_checked(state)) {}

Picture OverlayDrawer::draw(const StereoFrame& frame, const OverlayFrame& overlay,
                            const scene::OverlayInterest& interest) {
  scene::OverlayStatus status;
  status.model_unchecked = model_unchecked_;
  return painter_.paint(frame.left, overlay, status, interest);
}

std::optional<guidance::SurfacePlace> OverlayDrawer::place_at(const Eigen::Vector2d& pixel,
                                                              const OverlayFrame& overlay) const {
  return scene::place_at(*drawable_, camera_, overlay, pixel);
}

OverlayRecorder::OverlayRecorder(const engine::CaseState& state, const std::filesystem::path& path,
                                 double frames_per_second, const scene::OverlayStyle& style,
                                 const scene::OverlayInterest& interest)
    : drawer_(state, style),
      interest_(interest),
      writer_(path, state[part::rig]->left.width, state[part::rig]->left.height, frames_per_second) {}

double OverlayRecorder::add(const StereoFrame& frame, const OverlayFrame& overlay) {
  const auto begin = std::chrono::steady_clock::now();
  const Picture drawn = drawer_.draw(frame, overlay, interest_);
  const double milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  writer_.write(drawn);
  return milliseconds;
}

void OverlayRecorder::close() { writer_.close(); }

void follow_video(Session& session, const guidance::TrackerOptions& options, int last,
                  const std::function<void(const StereoFrame&, const OverlayFrame&)>& frame) {
  const engine::CaseState& state = session.state();
  session.need({part::video, part::frame});
  engine::StartTracking start;
  start.options = options;
  const int first = state[part::frame]->frame.index;
  session.post(start);
  stereo::StereoVideo video(session.state()[part::video]->left, session.state()[part::video]->right);
  const int end = last >= 0 ? last + 1 : video.frame_count();
  for (StereoFrame next; video.read(next);) {
    if (next.index < first) continue;
    frame(next, session.follow(next, static_cast<double>(next.index - first + 1) / (end - first)));
    if (last >= 0 && next.index >= last) break;
  }
}

}  // namespace glisson::app
