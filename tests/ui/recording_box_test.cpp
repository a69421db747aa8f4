// SPDX-License-Identifier: GPL-3.0-or-later
// Recording, as the box of the guidance panel offers it: what is said, what stands on the disk in the end.
#include <QComboBox>
#include <QTest>

#include "glisson/core/files.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/parts/live.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/common/drawable_source.h"
#include "glisson/ui/guidance/playback_box.h"
#include "glisson/ui/guidance/recording_box.h"
#include "guidance_bench.h"
#include "run_in_window.h"

namespace glisson {

using ui::EngineBridge;

namespace {

/// What records, without the window.
struct LiveRecording {
  explicit LiveRecording(EngineBridge& engine)
      : playback(engine),
        review(engine, playback),
        correction(engine, playback, review),
        again(engine, playback),
        model(worker, playback, correction, again) {
    QObject::connect(&worker, &ui::OverlayWorker::painted, &listener, [this] { ++painted; });
    QObject::connect(&worker, &ui::OverlayWorker::failed, &listener, [this] { ++failed; });
  }
  ui::OverlayWorker worker;
  ui::PlaybackModel playback;
  ui::ReviewModel review;
  ui::CorrectionModel correction;
  ui::AgainModel again;
  ui::RecordingModel model;
  int painted = 0, failed = 0;
  QObject listener;

  void start(const std::filesystem::path& file) { model.start(QString::fromStdString(file.string())); }
};

/// A live picture of the worker's own.
ui::OverlayJob live_job(int index) {
  ui::OverlayJob job;
  job.frame = FakeOperation::picture(64, 32, index);
  job.overlay.index = index;
  job.overlay.seconds = index / 30.0;
  job.taken = std::chrono::steady_clock::now();
  return job;
}

}  // namespace

class RecordingBoxTest : public QObject, GuidanceBench {
  Q_OBJECT
 private slots:
  void init() { set_up(); }
  void cleanup() { take_down(); }
  void RecordingIsOfferedWhileThereIsSomethingToRecord();
  void WhatIsRecordedIsChosenBefore();
  void RecordingEndsWithThePlaying();
  void RecordingThatFailsSaysWhy();
  void RecordingThatDrawingEndsSaysWhy();
  void RecordingThatIsTakenBackAtOnceEnds();
  void RecordingReplacesNothingBesideIt();
  void WhereTheFormerPatientsIsIsNotSaidOfTheNext();
  void WhatWasRegisteredMeanwhileIsWrittenWhateverComesNext();
};

void RecordingBoxTest::RecordingIsOfferedWhileThereIsSomethingToRecord() {
  LiveRecording live(*engine_);
  const ui::RecordingBox box(live.model);
  QVERIFY(!box.button()->isEnabled());
  QCOMPARE(box.button()->text(), QStringLiteral("Record…"));
  live.playback.is_tracking = true;
  QVERIFY(box.button()->isEnabled());
  live.start(folder_->path() / "live.mkv");
  QCOMPARE(box.button()->text(), QStringLiteral("Stop recording"));
  QVERIFY(words_on(box).startsWith(QStringLiteral("Recording to")));
  live.worker.submit(live_job(0));
  QTRY_COMPARE(live.painted, 1);
  box.button()->click();
  QTRY_VERIFY(!live.model.is_recording);
  QVERIFY2(words_on(box).startsWith(QStringLiteral("Frames recorded: 1")), qPrintable(words_on(box)));
}

void RecordingBoxTest::WhatIsRecordedIsChosenBefore() {
  LiveRecording live(*engine_);
  const ui::RecordingBox box(live.model);
  auto* what = box.findChild<QComboBox*>(QStringLiteral("recorded"));
  QVERIFY(live.model.what.value() == ui::Recorded::overlay);
  what->setCurrentIndex(2);
  QVERIFY(live.model.what.value() == ui::Recorded::both);
  const std::filesystem::path file = folder_->path() / "both.mkv";
  live.start(file);
  QVERIFY(!what->isEnabled());
  for (int k = 0; k < 3; ++k) {
    ui::OverlayJob job = live_job(k);
    job.right = FakeOperation::picture(64, 32, k + 1);
    live.worker.submit(job);
    QTRY_COMPARE(live.painted, k + 1);
  }
  live.model.stop();
  QTRY_VERIFY(!live.model.is_recording);
  QCOMPARE(live.model.tone.value(), QStringLiteral("good"));
  QVERIFY(what->isEnabled());
  stereo::StereoVideo raw(ui::Recorder::raw_path(file));
  QVERIFY(raw.width() == 64 && raw.frame_count() == 3);
  QVERIFY(std::filesystem::exists(file) && std::filesystem::exists(ui::Recorder::lines_path(file)));
}

/// A file's name may be a patient's.
void RecordingBoxTest::WhereTheFormerPatientsIsIsNotSaidOfTheNext() {
  LiveRecording live(*engine_);
  const ui::RecordingBox box(live.model);
  live.playback.is_tracking = true;
  live.start(folder_->path() / "doe.mkv");
  live.worker.submit(live_job(0));
  QTRY_COMPARE(live.painted, 1);
  live.model.stop();
  QTRY_VERIFY(!live.model.is_recording);
  QVERIFY(words_on(box).contains(QStringLiteral("doe.mkv")));
  post(engine::ImportImage{"ct.nii"});
  QVERIFY(words_on(box).contains(QStringLiteral("doe.mkv")));
  post(engine::ImportImage{"ct.nii", {}, true});
  QVERIFY2(!words_on(box).contains(QStringLiteral("doe.mkv")), qPrintable(words_on(box)));
}

void RecordingBoxTest::RecordingEndsWithThePlaying() {
  LiveRecording live(*engine_);
  live.start(folder_->path() / "early.mkv");
  QVERIFY(live.model.is_recording && live.model.is_offered);  // asked for before the playing begins
  live.playback.is_tracking = true;
  QVERIFY(!QTest::qWaitFor([&] { return !live.model.is_recording; }, 100));
  live.playback.is_frozen = true;
  QTRY_VERIFY(!live.model.is_recording);
  QCOMPARE(live.model.tone.value(), QStringLiteral("good"));
}

void RecordingBoxTest::RecordingThatFailsSaysWhy() {
  LiveRecording live(*engine_);
  const ui::RecordingBox box(live.model);
  live.start(folder_->path() / "no_such_folder" / "live.mkv");
  live.worker.submit(live_job(0));
  QTRY_VERIFY(!live.model.is_recording);
  QCOMPARE(live.model.tone.value(), QStringLiteral("error"));
  QVERIFY(!words_on(box).isEmpty());
}

void RecordingBoxTest::RecordingThatDrawingEndsSaysWhy() {
  reach_registration(4);
  const ui::DrawableSource drawables(*engine_);
  QTRY_VERIFY_WITH_TIMEOUT(drawables.drawable() != nullptr, 20000);
  LiveRecording live(*engine_);
  const ui::RecordingBox box(live.model);
  live.start(folder_->path() / "live.mkv");
  ui::OverlayJob wrong = live_job(1);  // smaller than the camera's pictures
  wrong.model = drawables.drawable();
  wrong.rig = std::make_shared<const StereoRig>(operation_->rig);
  wrong.taken.reset();
  live.worker.submit(wrong);
  QTRY_COMPARE(live.failed, 1);
  live.worker.submit(live_job(0));
  QTRY_COMPARE(live.painted, 1);
  QVERIFY(live.model.is_recording);  // a still picture is none of its own
  wrong.taken = std::chrono::steady_clock::now();
  live.worker.submit(wrong);
  QTRY_VERIFY(!live.model.is_recording);
  QCOMPARE(live.model.tone.value(), QStringLiteral("error"));
  QVERIFY2(words_on(box).contains(QStringLiteral("Use the calibration")) &&
               words_on(box).contains(QStringLiteral("Frames recorded: 1")),
           qPrintable(words_on(box)));
}

void RecordingBoxTest::RecordingThatIsTakenBackAtOnceEnds() {
  LiveRecording live(*engine_);
  int ended = 0;
  connect(&live.worker, &ui::OverlayWorker::recording_ended, &live.listener, [&ended] { ++ended; });
  ui::RecordingOptions options;
  options.path = folder_->path() / "never.mkv";
  for (int time = 1; time <= 3; ++time) {
    ui::OverlayJob busy = live_job(time);  // both wishes arrive while it is drawn
    busy.frame = FakeOperation::picture(1920, 1080, time);
    busy.taken.reset();
    live.worker.submit(busy);
    live.worker.start_recording(options);
    live.worker.stop_recording();
    QTRY_COMPARE(ended, time);
  }
}

void RecordingBoxTest::RecordingReplacesNothingBesideIt() {
  LiveRecording live(*engine_);
  live.model.what = ui::Recorded::both;
  const std::filesystem::path file = folder_->path() / "live.mkv";
  for (const std::filesystem::path& former : {ui::Recorder::raw_path(file), ui::Recorder::lines_path(file),
                                              folder_->path() / "live.mkv.corrections.jsonl"}) {
    write_file_atomically(former, "of a former recording");
    live.start(file);
    QVERIFY(!live.model.is_recording);
    QCOMPARE(live.model.tone.value(), QStringLiteral("error"));
    QVERIFY2(live.model.said.value().startsWith(QString::fromStdString(former.string())),
             qPrintable(live.model.said.value()));
    std::filesystem::remove(former);
  }
  live.start(file);
  QVERIFY(live.model.is_recording);
}

void RecordingBoxTest::WhatWasRegisteredMeanwhileIsWrittenWhateverComesNext() {
  operation_->again_is_better = false;
  reach_registration(200);
  LiveRecording live(*engine_);
  const ui::PlaybackBox box(*engine_, live.playback);
  const auto register_again = [&] {
    live.again.start_or_cancel();
    QTRY_COMPARE(live.again.record().size(), std::size_t{1});
  };
  const auto beside = [](const std::filesystem::path& film) { return film.string() + ".corrections.jsonl"; };
  task(box, "start_tracking")->trigger();
  QTRY_VERIFY(live.playback.is_playing && engine_->state()[part::live] &&
              engine_->state()[part::live]->frames > 0);
  live.playback.pause(true);
  const std::filesystem::path ended = folder_->path() / "ended.mkv", cut = folder_->path() / "cut.mkv";
  live.start(ended);
  register_again();
  live.model.stop();
  QCOMPARE(live.model.said.value(), QStringLiteral("The recording is being brought to its end."));
  emit live.playback.begun();
  QVERIFY(live.again.record().empty());
  QTRY_VERIFY(!live.model.is_recording);
  QVERIFY(read_file(beside(ended)).find("registered_again") != std::string::npos);
  // The window closes while it records.
  register_again();
  auto last = std::make_unique<ui::RecordingModel>(live.worker, live.playback, live.correction, live.again);
  last->start(QString::fromStdString(cut.string()));
  last.reset();
  QVERIFY(read_file(beside(cut)).find("registered_again") != std::string::npos);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::RecordingBoxTest>(argc, argv); }
#include "recording_box_test.moc"
