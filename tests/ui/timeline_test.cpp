// SPDX-License-Identifier: GPL-3.0-or-later
// The way through a recorded video: what is looked at again is as it was followed, and never called live.
#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "fake_operation.h"
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
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/moment_store.h"
#include "glisson/ui/guidance/timeline_bar.h"
#include "glisson/ui/guidance/timeline_track.h"
#include "live_part.h"
#include "run_in_window.h"

namespace glisson {
namespace {

struct Guidance : LivePart {
  using LivePart::LivePart;
  QString line() { return live.line; }
};

}  // namespace

class TimelineTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup();
  void APausedVideoStandsAndSaysSo();
  void AStepFollowsOneFrame();
  void AFormerFrameIsShownAndNeverLive();
  void MarksStandWhereTheLevelChanged();
  void AfterTheEndItIsPlayedAgain();
  void WhatIsNotFollowedNowNeverReadsAsValid();
  void TheFrameShownIsNeverBeyondTheLast();
  void AnotherRegistrationForgetsAll();
  void KeysDoWhatButtonsDo();
  void TheWholeScreenShowsTheSame();
  void TheSavedPictureIsTheOneOnTheScreen();
  void TheTrackAsksForTheFrameUnderThePointer();
  void TheStoreKeepsWhatFits();

 private:
  void post(engine::Command command) {
    engine_->post(std::move(command));
    QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  }
  void start(int frames) {
    for (const engine::Command& step : operation_->steps_to_cloud(folder_->path() / "scope.mkv", frames))
      post(step);
    post(engine::Register{});
    guidance_ = std::make_unique<Guidance>(*engine_);
    QTRY_VERIFY_WITH_TIMEOUT(guidance_->drawables.drawable() != nullptr, 20000);
    guidance_->playing.findChild<ui::TaskButton*>(QStringLiteral("start_tracking"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(guidance_->line().startsWith(QStringLiteral("LIVE")), 20000);
    QTRY_VERIFY_WITH_TIMEOUT(guidance_->review.last - guidance_->review.first >= 6, 20000);
  }
  /// Nothing is on its way any more.
  bool rests() {
    int index = -1;
    return QTest::qWaitFor(
        [&] {
          QTest::qWait(200);
          return std::exchange(index, guidance_->live.shown_index()) == guidance_->live.shown_index();
        },
        20000);
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<FakeOperation> operation_;
  std::unique_ptr<ui::EngineBridge> engine_;
  std::unique_ptr<Guidance> guidance_;
};

void TimelineTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  operation_ = std::make_unique<FakeOperation>();
  make_box_operation(*operation_);
  engine_ = std::make_unique<ui::EngineBridge>(operation_->options());
}

void TimelineTest::cleanup() {
  guidance_.reset();
  engine_.reset();
  operation_.reset();
  folder_.reset();
}

void TimelineTest::APausedVideoStandsAndSaysSo() {
  start(240);
  ui::ReviewModel& review = guidance_->review;
  QVERIFY(review.runs && review.is_offered);
  review.toggle();
  QVERIFY(guidance_->playback.is_paused && !review.runs);
  QVERIFY(rests());
  const int index = guidance_->live.shown_index();
  QTRY_VERIFY(guidance_->line().contains(QStringLiteral("Paused at frame %1").arg(index)));
  QCOMPARE(guidance_->live.is_fresh.value(), QVariant(false));
  QVERIFY(!guidance_->live.banner.value().isEmpty());
  QTRY_VERIFY(!guidance_->live.shows_live());
  QVERIFY(engine_->snapshot()->tracking);
  review.toggle();
  QVERIFY(review.runs);
  QTRY_VERIFY_WITH_TIMEOUT(guidance_->line().startsWith(QStringLiteral("LIVE")), 20000);
  QTRY_VERIFY_WITH_TIMEOUT(guidance_->live.shown_index() > index + 2, 20000);
  QVERIFY(guidance_->live.banner.value().isEmpty());
}

void TimelineTest::AStepFollowsOneFrame() {
  start(240);
  ui::ReviewModel& review = guidance_->review;
  review.toggle();
  QVERIFY(rests());
  for (int k = 0; k < 3; ++k) {
    const int last = review.last;
    QCOMPARE(review.position.value(), last);
    review.step(1);
    QTRY_COMPARE_WITH_TIMEOUT(review.last.value(), last + 1, 20000);
    QTRY_COMPARE_WITH_TIMEOUT(guidance_->live.shown_index(), last + 1, 20000);
  }
  QVERIFY(guidance_->playback.is_paused && !review.is_reviewing);
}

void TimelineTest::AFormerFrameIsShownAndNeverLive() {
  start(240);
  ui::ReviewModel& review = guidance_->review;
  const int wanted = review.first + 2;
  review.seek(wanted);
  QVERIFY(review.is_reviewing && !review.runs);
  const int shown = review.position;
  QVERIFY(std::abs(shown - wanted) <= 2);  // the nearest that was followed
  const auto is_recorded = [&](int index) {
    return guidance_->line() == QStringLiteral("Frame %1, recorded, not live").arg(index) &&
           guidance_->live.shown_index() == index && guidance_->live.is_fresh.value() == QVariant(false);
  };
  QTRY_VERIFY_WITH_TIMEOUT(is_recorded(shown), 20000);
  QVERIFY(!QTest::qWaitFor([&] { return !is_recorded(shown); }, 400));  // nothing live comes between
  review.step(1);
  QVERIFY(review.position > shown);
  QTRY_VERIFY_WITH_TIMEOUT(is_recorded(review.position), 20000);
  review.step(-1);
  QCOMPARE(review.position.value(), shown);
  QTRY_VERIFY_WITH_TIMEOUT(is_recorded(shown), 20000);
  review.seek(-100);
  QCOMPARE(review.position.value(), review.first.value());
  review.seek(1 << 20);
  QCOMPARE(review.position.value(), review.last.value());
  review.go_live();
  QVERIFY(!review.is_reviewing && review.runs);
  QTRY_VERIFY_WITH_TIMEOUT(guidance_->line().startsWith(QStringLiteral("LIVE")), 20000);
  QTRY_VERIFY_WITH_TIMEOUT(guidance_->live.is_fresh.value() == QVariant(true), 20000);
}

void TimelineTest::MarksStandWhereTheLevelChanged() {
  start(240);
  ui::ReviewModel& review = guidance_->review;
  QCOMPARE(review.marks.value().size(), std::size_t{1});
  operation_->live_validity = Validity::partly_covered;
  QTRY_COMPARE_WITH_TIMEOUT(review.marks.value().size(), std::size_t{2}, 20000);
  operation_->live_validity = Validity::surface_apart;
  QTRY_COMPARE_WITH_TIMEOUT(review.marks.value().size(), std::size_t{3}, 20000);
  const std::vector<ui::LevelMark> marks = review.marks;
  QVERIFY(marks[0].level == Level::valid && marks[1].level == Level::degraded &&
          marks[2].level == Level::withdrawn);
  QVERIFY(marks[0].index < marks[1].index && marks[1].index < marks[2].index);
  // What was withdrawn then is withdrawn when it is looked at again.
  review.seek(review.last);
  QTRY_VERIFY_WITH_TIMEOUT(guidance_->line().contains(QStringLiteral("recorded")), 20000);
  QCOMPARE(guidance_->live.lesions.value().front().state, QStringLiteral("not shown"));
}

void TimelineTest::AfterTheEndItIsPlayedAgain() {
  start(24);
  ui::ReviewModel& review = guidance_->review;
  QTRY_VERIFY_WITH_TIMEOUT(guidance_->playback.is_frozen && !engine_->snapshot()->tracking, 20000);
  QVERIFY(rests());
  QVERIFY(!review.runs);
  review.set_speed(2.0);
  review.toggle();
  QVERIFY(review.is_reviewing && review.runs);
  QTRY_VERIFY_WITH_TIMEOUT(!review.runs, 20000);
  QCOMPARE(review.position.value(), review.last.value());
  QTRY_COMPARE_WITH_TIMEOUT(guidance_->live.shown_index(), review.last.value(), 20000);
  QVERIFY(guidance_->line().contains(QStringLiteral("not live")));
  review.loops = true;
  // The last frame stands for some milliseconds only: every change is looked at.
  bool was_last = false;
  bool began_again = false;
  const auto watch = review.position.onValueChanged([&] {
    began_again = began_again || (was_last && review.position < review.last);
    was_last = review.position == review.last;
  });
  review.toggle();
  QTRY_VERIFY_WITH_TIMEOUT(began_again, 20000);
  QVERIFY(review.runs);
}

void TimelineTest::WhatIsNotFollowedNowNeverReadsAsValid() {
  start(240);
  QTRY_VERIFY_WITH_TIMEOUT(guidance_->live.shows_live(), 20000);
  guidance_->playback.stop();
  QVERIFY(rests());
  QVERIFY(!guidance_->live.shows_live());
  // A source that has gone away: tracking begins, and no picture comes.
  const auto begin = [this] {
    guidance_->playing.findChild<ui::TaskButton*>(QStringLiteral("start_tracking"))->trigger();
  };
  QTRY_VERIFY_WITH_TIMEOUT(!engine_->snapshot()->tracking, 20000);
  begin();
  QTRY_VERIFY_WITH_TIMEOUT(guidance_->live.shows_live(), 20000);
  guidance_->playback.stop();
  QTRY_VERIFY_WITH_TIMEOUT(!engine_->snapshot()->tracking, 20000);
  std::filesystem::remove(operation_->video);
  begin();
  QTRY_VERIFY_WITH_TIMEOUT(guidance_->live.banner.value().contains(QStringLiteral("scope.mkv")), 20000);
  QVERIFY(rests());
  QVERIFY(!guidance_->live.shows_live());
  QCOMPARE(guidance_->line(), QStringLiteral("Not live"));
}

void TimelineTest::TheFrameShownIsNeverBeyondTheLast() {
  start(60);
  const ui::TimelineBar bar(guidance_->review);
  const auto* place = bar.findChild<QLabel*>(QStringLiteral("timeline_place"));
  int seen = 0;
  bool is_ordered = true;
  const auto look = [&] {
    const QStringList numbers = place->text().split(QStringLiteral(" / "));
    ++seen;
    is_ordered = is_ordered && numbers.size() == 2 && numbers[0].toInt() <= numbers[1].toInt();
    return guidance_->playback.is_frozen.value();
  };
  QVERIFY(QTest::qWaitFor(look, 20000));
  QVERIFY(seen > 3 && is_ordered);
}

void TimelineTest::AnotherRegistrationForgetsAll() {
  start(24);
  ui::ReviewModel& review = guidance_->review;
  QTRY_VERIFY_WITH_TIMEOUT(guidance_->playback.is_frozen && !engine_->snapshot()->tracking, 20000);
  review.seek(review.first);
  QVERIFY(review.is_reviewing);
  post(engine::Register{});
  QTRY_VERIFY_WITH_TIMEOUT(!review.is_offered && !review.is_reviewing, 20000);
  QTRY_VERIFY_WITH_TIMEOUT(guidance_->line().startsWith(QStringLiteral("Registered frame 2")), 20000);
}

void TimelineTest::KeysDoWhatButtonsDo() {
  start(240);
  ui::ReviewModel& review = guidance_->review;
  QTest::keyClick(guidance_->picture(), Qt::Key_Space);
  QVERIFY(guidance_->playback.is_paused);
  QVERIFY(rests());
  QTest::keyClick(guidance_->picture(), Qt::Key_Left);
  QVERIFY(review.is_reviewing && review.position < review.last);
  QTest::keyClick(guidance_->picture(), Qt::Key_Home);
  QCOMPARE(review.position.value(), review.first.value());
  QTest::keyClick(guidance_->picture(), Qt::Key_Right, Qt::ShiftModifier);
  QVERIFY(review.position > review.first + 3);
  QTest::keyClick(guidance_->picture(), Qt::Key_End);
  QVERIFY(!review.is_reviewing && review.runs);
}

void TimelineTest::TheWholeScreenShowsTheSame() {
  start(240);
  QTest::keyClick(guidance_->picture(), Qt::Key_F11);
  const auto whole = []() -> ui::LiveView* {
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (widget->objectName() == QStringLiteral("whole_screen_view") && widget->isVisible())
        return qobject_cast<ui::LiveView*>(widget);
    return nullptr;
  };
  QTRY_VERIFY(whole() != nullptr);
  QVERIFY(whole()->isFullScreen());
  guidance_->review.toggle();
  QVERIFY(rests());
  QVERIFY(*whole()->picture().picture().bytes == *guidance_->picture()->picture().bytes);
  QTest::keyClick(whole()->findChild<ui::LivePicture*>(), Qt::Key_Escape);
  QTRY_VERIFY(whole() == nullptr);
  // It is of its window's case, and goes with its window.
  guidance_->view.setWindowTitle(QStringLiteral("one.glisson"));
  QTest::keyClick(guidance_->picture(), Qt::Key_F11);
  QTRY_VERIFY(whole() != nullptr);
  QCOMPARE(whole()->windowTitle(), QStringLiteral("one.glisson"));
  guidance_->view.setWindowTitle(QStringLiteral("other.glisson"));
  QCOMPARE(whole()->windowTitle(), QStringLiteral("other.glisson"));
  guidance_->view.hide();
  QTRY_VERIFY(whole() == nullptr);
}

void TimelineTest::TheSavedPictureIsTheOneOnTheScreen() {
  start(240);
  guidance_->review.toggle();
  QVERIFY(rests());
  const std::filesystem::path path = folder_->path() / "shot.png";
  QCOMPARE(ui::LiveViewModel::save_picture(guidance_->live.picture(), QString::fromStdString(path.string())),
           QString());
  QVERIFY(*stereo::read_picture(path).bytes == *guidance_->live.picture().bytes);
  const std::filesystem::path nowhere = folder_->path() / "no_such_folder" / "shot.png";
  QVERIFY(
      !ui::LiveViewModel::save_picture(guidance_->live.picture(), QString::fromStdString(nowhere.string()))
           .isEmpty());
}

void TimelineTest::TheTrackAsksForTheFrameUnderThePointer() {
  ui::TimelineTrack track;
  track.resize(300, 26);
  track.set_range(10, 110);
  const QSignalSpy wanted(&track, &ui::TimelineTrack::wanted);
  for (const int index : {10, 60, 110}) {
    QTest::mouseClick(&track, Qt::LeftButton, {},
                      QPoint(static_cast<int>(std::lround(track.place_of(index))), 13));
    QVERIFY(std::abs(wanted.back().at(0).toInt() - index) <= 1);
  }
  QTest::mouseClick(&track, Qt::LeftButton, {}, QPoint(0, 13));
  QCOMPARE(wanted.back().at(0).toInt(), 10);
}

void TimelineTest::TheStoreKeepsWhatFits() {
  const auto moment = [](int index) {
    ui::Moment made;
    made.left = FakeOperation::picture(64, 32, index);
    made.overlay.index = index;
    made.overlay.validity = Validity::valid;
    made.overlay.nodes_in_camera = Points::Constant(100, 3, index);
    return made;
  };
  ui::MomentStore store(16 * 2400);
  for (int i = 0; i < 40; ++i) {
    store.add(moment(i));
    QTRY_VERIFY(!store.entries().empty() && store.entries().back().index == i);
  }
  const auto entries = store.entries();
  QVERIFY(entries.size() >= 4 && entries.size() < 16);  // pictures need room, too
  QCOMPARE(entries.front().index, 40 - static_cast<int>(entries.size()));
  QVERIFY(!store.at(0));
  const auto last = store.at(39);
  QVERIFY(last && last->overlay.nodes_in_camera == moment(39).overlay.nodes_in_camera);
  QCOMPARE(last->left.width, 64);
  double apart = 0.0;
  const Picture original = moment(39).left;
  for (std::size_t i = 0; i < original.bytes->size(); ++i)
    apart +=
        std::abs(static_cast<double>((*original.bytes)[i]) - static_cast<double>((*last->left.bytes)[i]));
  QVERIFY(apart / static_cast<double>(original.bytes->size()) < 4.0);
  store.clear();
  QVERIFY(store.entries().empty());
  // A video that is repeated: the same frames again, and no more room taken.
  QObject receiver;
  int kept = 0;
  connect(&store, &ui::MomentStore::changed, &receiver, [&kept] { ++kept; });
  for (int round = 0; round < 12; ++round)
    for (int i = 0; i < 4; ++i) {
      const int before = kept;
      store.add(moment(i));
      QTRY_COMPARE(kept, before + 1);
    }
  QCOMPARE(store.entries().size(), std::size_t{4});
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::TimelineTest>(argc, argv); }
#include "timeline_test.moc"
