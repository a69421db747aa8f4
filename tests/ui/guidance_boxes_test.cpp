// SPDX-License-Identifier: GPL-3.0-or-later
// Each box of the guidance panel alone: its widgets say what its model's properties say.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include "fake_operation.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/load_video_frame.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/common/drawable_source.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/playback_box.h"
#include "glisson/ui/guidance/recording_box.h"
#include "glisson/ui/guidance/registration_box.h"
#include "run_in_window.h"

namespace glisson {

using engine::Part;
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

}  // namespace

class GuidanceBoxesTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup();
  void CouplingShowsNowAndAtEveryChange();
  void RegistrationSaysWhatItNeeds();
  void RegistrationShowsItsFiguresAndDoubts();
  void RefusedRegistrationIsUsedOnlyWhenSomebodySaysSo();
  void OtherPlacesAreOfferedAndTaken();
  void OtherPlacesAreSeenSideBySideAndTakenByAClick();
  void ADoubleClickTakesOnePlaceOnly();
  void TheFormerRegistrationIsOneClickAway();
  void TheMethodIsChosenInTheBox();
  void PlacedByHandTheModelIsRefinedFromThere();
  void PlacingEndsWithWhatItBelongsTo();
  void PlaybackSaysWhatItNeeds();
  void StopStaysWhereItIsWhenTrackingBegins();
  void PlaybackFreezesWhenItIsStopped();
  void FrozenPictureGoesWithItsRegistration();
  void PlaybackRepeatsOnlyWhenItShould_data();
  void PlaybackRepeatsOnlyWhenItShould();
  void RecordingIsOfferedWhileThereIsSomethingToRecord();
  void WhatIsRecordedIsChosenBefore();
  void RecordingEndsWithThePlaying();
  void RecordingThatFailsSaysWhy();
  void RecordingThatDrawingEndsSaysWhy();
  void RecordingThatIsTakenBackAtOnceEnds();
  void RecordingReplacesNothingBesideIt();
  void WhatWasRegisteredMeanwhileIsWrittenWhateverComesNext();

 private:
  void post(engine::Command command) {
    engine_->post(std::move(command));
    QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  }
  void reach_cloud(int frames) {
    for (const engine::Command& step : operation_->steps_to_cloud(folder_->path() / "scope.mkv", frames))
      post(step);
  }
  void reach_registration(int frames) {
    reach_cloud(frames);
    post(engine::Register{});
    QCOMPARE(engine_->snapshot()->stage(part::registration), engine::StageState::current);
  }
  static QString words_on(const QWidget& widget) {
    QStringList words;
    for (const QLabel* label : widget.findChildren<QLabel*>())
      if (!label->isHidden() && !label->text().isEmpty()) words << label->text();
    return words.join(QLatin1Char('\n'));
  }
  static ui::TaskButton* task(const QWidget& box, const char* name) {
    return box.findChild<ui::TaskButton*>(QString::fromLatin1(name));
  }
  static QPushButton* button(const QWidget& box, const char* name) {
    return box.findChild<QPushButton*>(QString::fromLatin1(name));
  }
  /// A live picture of the worker's own.
  static ui::OverlayJob live_job(int index) {
    ui::OverlayJob job;
    job.frame = FakeOperation::picture(64, 32, index);
    job.overlay.index = index;
    job.overlay.seconds = index / 30.0;
    job.taken = std::chrono::steady_clock::now();
    return job;
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<FakeOperation> operation_;
  std::unique_ptr<EngineBridge> engine_;
};

void GuidanceBoxesTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  operation_ = std::make_unique<FakeOperation>();
  make_box_operation(*operation_);
  engine_ = std::make_unique<EngineBridge>(operation_->options());
}

void GuidanceBoxesTest::cleanup() {
  engine_.reset();
  operation_.reset();
  folder_.reset();
}

void GuidanceBoxesTest::CouplingShowsNowAndAtEveryChange() {
  QProperty<int> first{1};
  QProperty<int> twice;
  twice.setBinding([&first] { return 2 * first; });
  std::vector<int> shown;
  {
    ui::Couplings couplings;
    couplings.add(twice, [&shown](int value) { shown.push_back(value); });
    first = 2;
    first = 2;
    first = 3;
  }
  first = 4;
  QCOMPARE(shown, (std::vector<int>{2, 4, 6}));
}

void GuidanceBoxesTest::RegistrationSaysWhatItNeeds() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  QVERIFY(words_on(box).contains(QStringLiteral("Build a model first.")));
  QVERIFY(!task(box, "register")->button()->isEnabled());
  post(engine::ImportImage{"ct.nii"});
  post(engine::SetSeeds{});
  post(engine::Segment{});
  post(engine::BuildModel{});
  QVERIFY(words_on(box).contains(QStringLiteral("Reconstruct the surface first (Stereo).")));
  reach_cloud(4);
  QVERIFY(task(box, "register")->button()->isEnabled());
  post(engine::SetSeeds{});
  QVERIFY(words_on(box).contains(QStringLiteral("The labels are out of date")));
  QVERIFY(!task(box, "register")->button()->isEnabled());
}

void GuidanceBoxesTest::RegistrationShowsItsFiguresAndDoubts() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  const auto* doubts = box.findChild<QLabel*>(QStringLiteral("registration_doubts"));
  QVERIFY(doubts->isHidden());
  reach_registration(4);
  QVERIFY(words_on(box).contains(QStringLiteral("1.10 mm")));
  QVERIFY(words_on(box).contains(QStringLiteral("came to rest")));
  QVERIFY(!doubts->isHidden() && !doubts->text().isEmpty());
  QVERIFY(!box.findChild<QLabel*>(QStringLiteral("model_unchecked"))->isHidden());
}

void GuidanceBoxesTest::RefusedRegistrationIsUsedOnlyWhenSomebodySaysSo() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  ui::TaskButton* accept = task(box, "accept_registration");
  QVERIFY(accept->isHidden());
  operation_->doubts = {"refused", "cloud_noisy 6.3 6"};
  reach_registration(4);
  QVERIFY(!accept->isHidden());
  QVERIFY(words_on(box).contains(QStringLiteral("refused")));
  QVERIFY(!words_on(box).contains(QStringLiteral("came to rest")));  // nothing that sounds like success
  QVERIFY(model.error_words.value().startsWith(QStringLiteral("Refused")));
  QVERIFY(model.spots.value().empty());
  const auto first = engine::obstacle(*engine_->snapshot(), engine::StartTracking{});
  QVERIFY(first && first->kind == engine::Obstacle::Kind::refused);
  ui::PlaybackModel playback(*engine_);
  QVERIFY(playback.obstacle.value().contains(QStringLiteral("refused")));
  QVERIFY_EXCEPTION_THROWN(
      engine::apply(engine_->state(), engine::StartTracking{}, RunContext(), engine::Services{}), InputError);
  accept->trigger();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(accept->isHidden());
  QVERIFY2(words_on(box).contains(QStringLiteral("scatter by 6.30 mm")),
           qPrintable(words_on(box)));  // it stays
  QVERIFY(model.error_words.value().startsWith(QStringLiteral("Expected error")));
  QCOMPARE(model.spots.value().size(), std::size_t{2});
  post(engine::SetSeeds{});
  QVERIFY(model.error_words.value().startsWith(QStringLiteral("Out of date")));
  QVERIFY(model.spots.value().empty());
}

void GuidanceBoxesTest::OtherPlacesAreOfferedAndTaken() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  reach_registration(4);
  const auto* rows = box.findChild<QWidget*>(QStringLiteral("rivals"));
  QVERIFY(rows->isHidden());
  QVERIFY(words_on(box).contains(QStringLiteral("7.0 mm")));  // the expected error's mean
  operation_->rival_away = 0.014;
  post(engine::Register{});
  QVERIFY(!rows->isHidden());
  auto* choice = box.findChild<QComboBox*>(QStringLiteral("rival"));
  QCOMPARE(choice->count(), 2);
  QCOMPARE(choice->itemText(1), QStringLiteral("Other place 1: 12 %, 14 mm away"));
  QVERIFY(!task(box, "choose_rival")->button()->isEnabled());
  QVERIFY(model.rival_nodes() == nullptr);
  choice->setCurrentIndex(1);
  emit choice->activated(1);
  const Points there = *model.rival_nodes();
  task(box, "choose_rival")->trigger();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(engine_->state()[part::registration]->nodes_in_camera == there);
  QCOMPARE(choice->itemText(1), QStringLiteral("Other place 1: 88 %, 14 mm away"));
  QVERIFY(model.rival_nodes() == nullptr);  // nothing is compared until somebody chooses
  QVERIFY(words_on(box).contains(QStringLiteral("gave it 12 %")));
}

void GuidanceBoxesTest::OtherPlacesAreSeenSideBySideAndTakenByAClick() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  operation_->rival_away = 0.014;
  reach_registration(4);
  auto* first = box.findChild<QToolButton*>(QStringLiteral("take_rival_1"));
  QVERIFY(!first->isHidden());
  QVERIFY(box.findChild<QToolButton*>(QStringLiteral("take_rival_2"))->isHidden());
  QCOMPARE(first->text(), QStringLiteral("1: 12 %, 14 mm"));
  // The organ lies over the picture where that place puts it.
  const Registration& registration = *engine_->state()[part::registration];
  const QImage drawn = first->icon().pixmap(first->iconSize()).toImage();
  const Eigen::Vector2d at = operation_->rig.left.project(
      Eigen::Vector3d(registration.rivals[0].nodes_in_camera.colwise().mean().transpose()));
  const double scale = std::max(drawn.width() / static_cast<double>(operation_->rig.left.width),
                                drawn.height() / static_cast<double>(operation_->rig.left.height));
  const QPoint pixel(
      static_cast<int>(scale * at.x() - 0.5 * (scale * operation_->rig.left.width - drawn.width())),
      static_cast<int>(scale * at.y() - 0.5 * (scale * operation_->rig.left.height - drawn.height())));
  QVERIFY(drawn.rect().contains(pixel));
  const QColor organ = drawn.pixelColor(pixel), corner = drawn.pixelColor(1, 1);
  QVERIFY2(organ.blue() > organ.red() && corner.blue() <= corner.red(),
           qPrintable(organ.name() + corner.name()));
  const Points there = registration.rivals[0].nodes_in_camera;
  first->click();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(engine_->state()[part::registration]->nodes_in_camera == there);
  QCOMPARE(first->text(), QStringLiteral("1: 88 %, 14 mm"));
}

void GuidanceBoxesTest::ADoubleClickTakesOnePlaceOnly() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  const auto usual = qScopeGuard(
      [interval = QApplication::doubleClickInterval()] { QApplication::setDoubleClickInterval(interval); });
  QApplication::setDoubleClickInterval(2000);  // however slow the machine is
  operation_->rival_away = 0.014;
  reach_registration(4);
  auto* first = box.findChild<QToolButton*>(QStringLiteral("take_rival_1"));
  const Points there = engine_->state()[part::registration]->rivals[0].nodes_in_camera;
  for (int click = 0; click < 2; ++click) {  // by the second the picture shows the place that was left
    first->click();
    QVERIFY(!first->isEnabled());
    QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  }
  QVERIFY(engine_->state()[part::registration]->nodes_in_camera == there);
  QTRY_VERIFY(first->isEnabled());
  first->click();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(engine_->state()[part::registration]->nodes_in_camera != there);
  QTRY_VERIFY(first->isEnabled());
  post(engine::StartTracking{});
  QVERIFY(!first->isEnabled() && first->toolTip().contains(QStringLiteral("stop tracking first")));
}

void GuidanceBoxesTest::TheFormerRegistrationIsOneClickAway() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  reach_registration(4);
  QPushButton* undo = button(box, "undo_registration");
  QVERIFY(undo->isHidden());
  const auto first = engine_->state()[part::registration];
  operation_->rival_away = 0.014;
  post(engine::Register{});
  const auto second = engine_->state()[part::registration];
  QVERIFY(!undo->isHidden() && second != first);
  const auto press = [&] {
    undo->click();
    QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  };
  press();
  QVERIFY(engine_->state()[part::registration] == first);
  QCOMPARE(engine_->snapshot()->stage(part::registration), engine::StageState::current);
  press();
  QVERIFY(engine_->state()[part::registration] == second);
  // While the organ is followed it keeps its room, so that no button below it moves.
  post(engine::StartTracking{});
  QVERIFY(!undo->isHidden() && !undo->isEnabled());
}

void GuidanceBoxesTest::TheMethodIsChosenInTheBox() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  reach_cloud(4);
  task(box, "register")->trigger();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(operation_->method == registration::Method::automatic);
  auto* choice = box.findChild<QComboBox*>(QStringLiteral("registration_method"));
  QCOMPARE(choice->count(), 4);
  choice->setCurrentIndex(3);
  emit choice->activated(3);
  task(box, "register")->trigger();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(operation_->method == registration::Method::paper);
  button(box, "place_by_hand")->click();
  task(box, "refine")->trigger();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(operation_->method == registration::Method::paper && operation_->start);
}

void GuidanceBoxesTest::PlacedByHandTheModelIsRefinedFromThere() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  QVERIFY(!button(box, "place_by_hand")->isEnabled());
  reach_cloud(4);
  button(box, "place_by_hand")->click();
  QVERIFY(placing.is_placing);
  const auto where = [&] { return Eigen::Vector3d(placing.nodes().colwise().mean().transpose()); };
  const Eigen::Vector2d at = operation_->rig.left.project(where()), to = at + Eigen::Vector2d(40.0, -25.0);
  placing.drag(at, to, ui::PlacingModel::Move::along);
  QVERIFY((operation_->rig.left.project(where()) - to).norm() < 1e-3);
  placing.drag({100, 90}, {180, 90}, ui::PlacingModel::Move::turn);
  // 80 of 320 pixels: a quarter of half a circle, about the vertical.
  const Eigen::AngleAxisd turn(placing.pose().rotation * operation_->camera_from_ct.rotation.transpose());
  QVERIFY(std::abs(turn.angle() - M_PI / 4.0) < 1e-9 && turn.axis().y() > 0.999);
  const double before = where().norm();
  placing.bring_nearer(1.0);
  QVERIFY(std::abs(where().norm() / before - 0.97) < 1e-9);
  const CameraFromCt held = placing.pose();
  task(box, "refine")->trigger();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(operation_->start && operation_->start->rotation == held.rotation &&
          operation_->start->translation == held.translation);
  QTRY_VERIFY(!placing.is_placing);
}

void GuidanceBoxesTest::PlacingEndsWithWhatItBelongsTo() {
  ui::PlacingModel placing(*engine_);
  reach_registration(4);
  placing.start();
  QVERIFY(placing.is_placing);
  QVERIFY(placing.pose().translation == operation_->camera_from_ct.translation);
  post(engine::LoadVideoFrame{1});
  QVERIFY(!placing.is_placing);
}

void GuidanceBoxesTest::PlaybackSaysWhatItNeeds() {
  ui::PlaybackModel model(*engine_);
  const ui::PlaybackBox box(*engine_, model);
  QVERIFY(words_on(box).contains(QStringLiteral("Register first.")));
  reach_registration(200);
  QVERIFY(task(box, "start_tracking")->button()->isEnabled());
  QVERIFY(!button(box, "stop_tracking")->isEnabled());
  task(box, "start_tracking")->trigger();
  QTRY_VERIFY(model.is_tracking);
  QVERIFY(words_on(box).contains(QStringLiteral("Tracking is running.")));
  QVERIFY(button(box, "stop_tracking")->isEnabled());
}

void GuidanceBoxesTest::StopStaysWhereItIsWhenTrackingBegins() {
  ui::PlaybackModel model(*engine_);
  ui::PlaybackBox box(*engine_, model);
  reach_registration(200);
  box.show();
  const auto stop_at = [&] {
    QCoreApplication::processEvents();
    box.resize(320, box.sizeHint().height());
    box.layout()->activate();
    return button(box, "stop_tracking")->mapTo(&box, QPoint(0, 0)).y();
  };
  const int before = stop_at();
  task(box, "start_tracking")->trigger();
  QTRY_VERIFY(model.is_tracking && !task(box, "start_tracking")->is_running());
  QVERIFY(words_on(box).contains(QStringLiteral("Tracking is running.")));
  QTRY_COMPARE(stop_at(), before);
}

void GuidanceBoxesTest::PlaybackFreezesWhenItIsStopped() {
  ui::PlaybackModel model(*engine_);
  const ui::PlaybackBox box(*engine_, model);
  reach_registration(200);
  task(box, "start_tracking")->trigger();
  QTRY_VERIFY(model.is_playing);
  button(box, "stop_tracking")->click();
  QVERIFY(model.is_frozen && !model.is_playing);
  QVERIFY(model.frozen_why.value().contains(QStringLiteral("Last picture, not live")));
  QTRY_VERIFY(!model.is_tracking);
  QVERIFY(model.is_frozen);
  QVERIFY(task(box, "start_tracking")->button()->isEnabled());
}

void GuidanceBoxesTest::FrozenPictureGoesWithItsRegistration() {
  ui::PlaybackModel model(*engine_);
  const ui::PlaybackBox box(*engine_, model);
  reach_registration(200);
  task(box, "start_tracking")->trigger();
  QTRY_VERIFY(model.is_playing);
  model.stop();
  QTRY_VERIFY(!model.is_tracking);
  post(engine::Register{});
  QVERIFY(!model.is_frozen);
}

void GuidanceBoxesTest::PlaybackRepeatsOnlyWhenItShould_data() {
  QTest::addColumn<bool>("repeats");
  QTest::newRow("once") << false;
  QTest::newRow("again") << true;
}

void GuidanceBoxesTest::PlaybackRepeatsOnlyWhenItShould() {
  QFETCH(bool, repeats);
  ui::PlaybackModel model(*engine_);
  const ui::PlaybackBox box(*engine_, model);
  reach_registration(8);
  box.findChild<QCheckBox*>()->setChecked(repeats);
  QCOMPARE(model.repeats.value(), repeats);
  QSignalSpy begun(&model, &ui::PlaybackModel::begun);
  task(box, "start_tracking")->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(begun.count() >= (repeats ? 3 : 1), 20000);
  if (repeats) return;
  QTRY_VERIFY(model.is_frozen && !model.is_tracking);
  QVERIFY(model.frozen_why.value().contains(QStringLiteral("The video has ended")));
  QVERIFY(!QTest::qWaitFor([&] { return begun.count() > 1; }, 300));
}

void GuidanceBoxesTest::RecordingIsOfferedWhileThereIsSomethingToRecord() {
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

void GuidanceBoxesTest::WhatIsRecordedIsChosenBefore() {
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

void GuidanceBoxesTest::RecordingEndsWithThePlaying() {
  LiveRecording live(*engine_);
  live.start(folder_->path() / "early.mkv");
  QVERIFY(live.model.is_recording && live.model.is_offered);  // asked for before the playing begins
  live.playback.is_tracking = true;
  QVERIFY(!QTest::qWaitFor([&] { return !live.model.is_recording; }, 100));
  live.playback.is_frozen = true;
  QTRY_VERIFY(!live.model.is_recording);
  QCOMPARE(live.model.tone.value(), QStringLiteral("good"));
}

void GuidanceBoxesTest::RecordingThatFailsSaysWhy() {
  LiveRecording live(*engine_);
  const ui::RecordingBox box(live.model);
  live.start(folder_->path() / "no_such_folder" / "live.mkv");
  live.worker.submit(live_job(0));
  QTRY_VERIFY(!live.model.is_recording);
  QCOMPARE(live.model.tone.value(), QStringLiteral("error"));
  QVERIFY(!words_on(box).isEmpty());
}

void GuidanceBoxesTest::RecordingThatDrawingEndsSaysWhy() {
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

void GuidanceBoxesTest::RecordingThatIsTakenBackAtOnceEnds() {
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

void GuidanceBoxesTest::RecordingReplacesNothingBesideIt() {
  LiveRecording live(*engine_);
  live.model.what = ui::Recorded::both;
  const std::filesystem::path file = folder_->path() / "live.mkv";
  for (const auto& former : {ui::Recorder::raw_path(file), ui::Recorder::lines_path(file)}) {
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

void GuidanceBoxesTest::WhatWasRegisteredMeanwhileIsWrittenWhateverComesNext() {
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

int main(int argc, char** argv) { return glisson::run_in_window<glisson::GuidanceBoxesTest>(argc, argv); }
#include "guidance_boxes_test.moc"
