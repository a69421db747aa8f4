// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/recording_model.h"

#include <string>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/ui/common/error_texts.h"

namespace glisson::ui {

RecordingModel::RecordingModel(OverlayWorker& worker, PlaybackModel& playback, CorrectionModel& correction,
                               AgainModel& again, QObject* parent)
    : QObject(parent), worker_(worker), correction_(correction), again_(again) {
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
              tell_end(path, frames);
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

void RecordingModel::tell_end(const QString& path, int frames) {
  QString text = tr("Frames recorded: %1, in %2").arg(frames).arg(path);
  std::string lines;
  for (const auto* record : {&correction_.record(), &again_.record()})
    for (const std::string& line : *record) lines += line + "\n";
  if (!lines.empty()) {
    const QString beside = path + QStringLiteral(".corrections.jsonl");
    try {
      write_file_atomically(beside.toStdString(), lines);
    } catch (const Error& problem) {
      return say(error_text(problem.what()), QStringLiteral("error"));
    }
    text += QLatin1Char('\n') + tr("Corrections and registrations made meanwhile: %1").arg(beside);
  }
  say(text, QStringLiteral("good"));
}

void RecordingModel::say(const QString& text, const QString& how) {
  tone = how;
  said = text;
}

}  // namespace glisson::ui
