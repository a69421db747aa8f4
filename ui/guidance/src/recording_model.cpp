// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/recording_model.h"

#include <exception>
#include <filesystem>
#include <string>
#include <system_error>
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
  connect(&playback, &PlaybackModel::case_read, this,
          [this, &playback, of = playback.case_number()]() mutable {
            const std::uint64_t former = std::exchange(of, playback.case_number());
            if (former != of && !is_recording) say({}, {});  // it names files of another patient
          });
  couplings_.add(playback.is_playing, end_with);
  couplings_.add(playback.is_tracking, end_with);
  connect(&worker_, &OverlayWorker::recording_left_out, this, [this](int pictures) {
    if (!is_recording || is_ending) return;
    say(recording_ + QLatin1Char('\n') + left_out_text(pictures), QStringLiteral("warning"));
  });
  connect(&worker_, &OverlayWorker::recording_failed, this, [this](const QString& error) {
    begin_end();
    say(error, QStringLiteral("error"));
  });
  connect(&worker_, &OverlayWorker::recording_ended, this, &RecordingModel::take_end);
}

RecordingModel::~RecordingModel() {
  if (!is_recording) return;
  try {
    const std::string lines = is_ending ? lines_ : lines_now();
    if (!lines.empty()) write_file_atomically(beside(path_).toStdString(), lines);
  } catch (const std::exception&) {
    // Nobody is there to be told.
  }
}

void RecordingModel::start(const QString& path) {
  if (is_recording) return;
  for (const std::filesystem::path& file :
       {Recorder::raw_path(path.toStdString()), Recorder::lines_path(path.toStdString()),
        std::filesystem::path(beside(path).toStdString())})
    if (std::error_code ignored; std::filesystem::exists(file, ignored))
      return say(
          tr("%1: lies there already. Choose another name.").arg(QString::fromStdString(file.string())),
          QStringLiteral("error"));
  RecordingOptions options;
  options.path = path.toStdString();
  options.what = what.value();
  options.remedy = scene::remedy_text;
  worker_.start_recording(std::move(options));
  is_recording = true;
  path_ = path;
  recording_ = tr("Recording to %1").arg(path);
  say(recording_, QStringLiteral("warning"));
}

void RecordingModel::stop() {
  if (!is_recording || is_ending) return;
  begin_end();
  say(tr("The recording is being brought to its end."), QStringLiteral("warning"));
  worker_.stop_recording();
}

void RecordingModel::begin_end() {
  correction_.settle();  // a hand may hold the organ still
  if (!is_ending) lines_ = lines_now();
  is_ending = true;
}

std::string RecordingModel::lines_now() const {
  std::string lines;
  for (const auto* record : {&correction_.record(), &again_.record()})
    for (const std::string& line : *record) lines += line + "\n";
  return lines;
}

QString RecordingModel::beside(const QString& path) { return path + QStringLiteral(".corrections.jsonl"); }

QString RecordingModel::left_out_text(int pictures) {
  return tr("Pictures left out because the computer or its disk is too slow: %1").arg(pictures);
}

void RecordingModel::take_end(const RecordingEnd& end) {
  if (!end.error.isEmpty()) worker_.stop_recording();  // it has ended by itself
  begin_end();
  is_recording = false;
  is_ending = false;
  tell_end(end);
}

void RecordingModel::tell_end(const RecordingEnd& end) {
  QString text = tr("Frames recorded: %1, in %2").arg(end.frames).arg(end.path);
  if (end.repeated > 0)
    text += QLatin1Char('\n') +
            tr("Frames in which the picture before stays, as none came in time: %1").arg(end.repeated);
  if (end.left_out > 0) text += QLatin1Char('\n') + left_out_text(end.left_out);
  if (!end.error.isEmpty()) text = end.error + QLatin1Char('\n') + text;
  if (!lines_.empty()) {
    const QString file = beside(end.path);
    try {
      write_file_atomically(file.toStdString(), lines_);
    } catch (const Error& problem) {
      return say(text + QLatin1Char('\n') + error_text(problem.what()), QStringLiteral("error"));
    }
    text += QLatin1Char('\n') + tr("Corrections and registrations made meanwhile: %1").arg(file);
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
