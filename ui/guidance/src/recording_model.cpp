// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/recording_model.h"

#include <string>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/ui/common/error_texts.h"

namespace glisson::ui {

RecordingModel::RecordingModel(OverlayWorker& worker, PlaybackModel& playback, CorrectionModel& correction,
                               AgainModel& again, QObject* parent)
    : QObject(parent), worker_(worker), correction_(correction), again_(again) {
  is_offered.setBinding([this, &playback] { return (playback.is_tracking || is_recording) && !is_ending; });
  const auto end_with = [this](bool goes_on) {
    if (!goes_on) stop();
  };
  couplings_.add(playback.is_playing, end_with);
  couplings_.add(playback.is_tracking, end_with);
  connect(&worker_, &OverlayWorker::recording_left_out, this, [this](int pictures) {
    if (!is_recording || is_ending) return;
    say(recording_ + QLatin1Char('\n') + left_out_text(pictures), QStringLiteral("warning"));
  });
  connect(&worker_, &OverlayWorker::recording_failed, this, [this](const QString& error) {
    is_ending = true;
    say(error, QStringLiteral("error"));
  });
  connect(&worker_, &OverlayWorker::recording_ended, this, &RecordingModel::take_end);
}

void RecordingModel::start(const QString& path) {
  if (is_recording) return;
  RecordingOptions options;
  options.path = path.toStdString();
  options.what = what.value();
  options.remedy = scene::remedy_text;
  worker_.start_recording(std::move(options));
  is_recording = true;
  recording_ = tr("Recording to %1").arg(path);
  say(recording_, QStringLiteral("warning"));
}

void RecordingModel::stop() {
  if (!is_recording || is_ending) return;
  is_ending = true;
  worker_.stop_recording();
}

QString RecordingModel::left_out_text(int pictures) {
  return tr("Pictures left out because the computer or its disk is too slow: %1").arg(pictures);
}

void RecordingModel::take_end(const RecordingEnd& end) {
  if (!end.error.isEmpty()) worker_.stop_recording();  // it has ended by itself
  is_recording = false;
  is_ending = false;
  tell_end(end);
}

void RecordingModel::tell_end(const RecordingEnd& end) {
  QString text = tr("Frames recorded: %1, in %2").arg(end.frames).arg(end.path);
  if (end.left_out > 0) text += QLatin1Char('\n') + left_out_text(end.left_out);
  if (!end.error.isEmpty()) text = end.error + QLatin1Char('\n') + text;
  std::string lines;
  for (const auto* record : {&correction_.record(), &again_.record()})
    for (const std::string& line : *record) lines += line + "\n";
  if (!lines.empty()) {
    const QString beside = end.path + QStringLiteral(".corrections.jsonl");
    try {
      write_file_atomically(beside.toStdString(), lines);
    } catch (const Error& problem) {
      return say(text + QLatin1Char('\n') + error_text(problem.what()), QStringLiteral("error"));
    }
    text += QLatin1Char('\n') + tr("Corrections and registrations made meanwhile: %1").arg(beside);
  }
  const bool is_whole = end.error.isEmpty() && end.left_out == 0;
  say(text, is_whole              ? QStringLiteral("good")
            : end.error.isEmpty() ? QStringLiteral("warning")
                                  : QStringLiteral("error"));
}

void RecordingModel::say(const QString& text, const QString& how) {
  tone = how;
  said = text;
}

}  // namespace glisson::ui
