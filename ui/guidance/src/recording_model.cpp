// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/recording_model.h"

namespace glisson::ui {

RecordingModel::RecordingModel(OverlayWorker& worker, PlaybackModel& playback, QObject* parent)
    : QObject(parent), worker_(worker) {
  is_offered.setBinding([this, &playback] { return playback.is_tracking || is_recording; });
  const auto end_with = [this](bool goes_on) {
    if (!goes_on) stop();
  };
  couplings_.add(playback.is_playing, end_with);
  couplings_.add(playback.is_tracking, end_with);
  connect(&worker_, &OverlayWorker::recording_ended, this,
          [this](const QString& path, int frames, const QString& error) {
            is_recording = false;
            if (error.isEmpty())
              say(tr("Frames recorded: %1, in %2").arg(frames).arg(path), QStringLiteral("good"));
            else
              say(error, QStringLiteral("error"));
          });
}

void RecordingModel::start(const QString& path) {
  worker_.start_recording(path.toStdString());
  is_recording = true;
  say(tr("Recording to %1").arg(path), QStringLiteral("warning"));
}

void RecordingModel::stop() {
  if (is_recording) worker_.stop_recording();
}

void RecordingModel::say(const QString& text, const QString& how) {
  tone = how;
  said = text;
}

}  // namespace glisson::ui
