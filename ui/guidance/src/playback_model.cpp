// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/playback_model.h"

#include <utility>

#include "glisson/engine/commands/stop_tracking.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/video.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {

PlaybackModel::PlaybackModel(EngineBridge& engine, QObject* parent)
    : QObject(parent),
      engine_(engine),
      feed_([&engine](StereoFrame frame) { engine.submit_frame(std::move(frame)); }) {
  is_playing.setBinding([this] { return is_tracking && !is_frozen; });
  obstacle.setBinding([this] { return is_tracking ? tr("Tracking is running.") : requirement_.value(); });
  connect(&feed_, &VideoFeed::ended, this, [this] {
    if (!is_playing) return;
    starts_again_ = repeats;
    freeze(tr("The video has ended. Last picture, not live."));
  });
  connect(&feed_, &VideoFeed::failed, this, [this](const QString& message) {
    if (is_playing) freeze(message);
  });
  connect(&engine_, &EngineBridge::case_changed, this, &PlaybackModel::read_case);
  read_case();
}

engine::StartTracking PlaybackModel::command() const {
  engine::StartTracking start;
  start.source = engine::StartTracking::Source::video;
  start.mask.network = mask_network.value().toStdString();
  return start;
}

QString PlaybackModel::requirement(const engine::Snapshot& now) {
  engine::StartTracking start;
  start.source = engine::StartTracking::Source::video;
  return obstacle_text(engine::obstacle(now, start));
}

void PlaybackModel::begin(const engine::Outcome& outcome) {
  const engine::CaseState& now = engine_.state();
  if (outcome.status != engine::Status::done || !now[part::video] || !now[part::frame]) return;
  if (!engine_.snapshot()->tracking) return;  // ended already, as by another case
  unfreeze();
  is_paused = false;
  emit begun();
  feed_.start(*now[part::video], now[part::frame]->frame.index + 1);
}

void PlaybackModel::stop() {
  starts_again_ = false;
  freeze(tr("Tracking was stopped. Last picture, not live."));
}

void PlaybackModel::pause(bool on) {
  if (!is_playing) return;
  feed_.pause(on);
  is_paused = on;
}

void PlaybackModel::freeze(const QString& why) {
  feed_.stop();
  if (engine_.snapshot()->tracking) engine_.post(engine::StopTracking{});
  frozen_registration_ = engine_.state()[part::registration];
  frozen_why = why;
  is_frozen = true;
  is_paused = false;
}

void PlaybackModel::unfreeze() {
  starts_again_ = false;
  is_frozen = false;
  frozen_why = QString();
  frozen_registration_.reset();
}

void PlaybackModel::read_case() {
  const engine::Snapshot& now = *engine_.snapshot();
  requirement_ = requirement(now);
  if (is_tracking && !now.tracking) feed_.stop();
  const bool outdated = !now.state[part::frame] || now.state[part::registration] != frozen_registration_ ||
                        now.stage(part::registration) != engine::StageState::current;
  if (is_frozen && outdated) unfreeze();
  is_tracking = now.tracking;
  if (!is_tracking) is_paused = false;
  emit case_read();
  if (!now.tracking && std::exchange(starts_again_, false)) emit start_wanted();
}

}  // namespace glisson::ui
