// SPDX-License-Identifier: GPL-3.0-or-later
// What the guidance panel tells while the organ is followed, and of the last picture when it ends.
#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <atomic>
#include <functional>
#include <numeric>

#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/video.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/guidance/video_feed.h"
#include "guidance_window.h"

namespace glisson {

using ui::MainWindow;

class GuidanceLiveTest : public QObject, protected GuidanceWindow {
  Q_OBJECT
 private slots:
  void init() { open_window(); }
  void cleanup() { close_window(); }
  void EveryPlayingKnowsWhenItsFramesWereSent();
  void NothingOfTheFormerLiveViewStays();
  void TheLiveLineTellsTheLevelAndWhy();
  void TimesFromTheCameraToTheScreenAreTold();
  void TheRawPictureStandsBesideTheOverlay();
  void TheTableTellsOfEachLesion();
  void LastPictureStaysUntilAnotherCaseWhateverItsStyle();
  void OverTheLastPictureKeysTakeNoRegistrationBack();
  void OverTheLastPictureAHandSeesWhatItPlaces();
  void InAPauseTheOverlayGoesWithItsRegistration();
  void WhatIsDrawnForHandsIsKnownAsRefuted();
  void APictureOfUnknownAgeIsNotLive();
};

void GuidanceLiveTest::EveryPlayingKnowsWhenItsFramesWereSent() {
  using Clock = ui::VideoFeed::Clock;
  constexpr int kFrames = 130;  // more than a feed remembers
  const std::filesystem::path file = folder_->path() / "fast.mkv";
  stereo::VideoWriter writer(file, 64, 32, 250.0);
  for (int i = 0; i < kFrames; ++i) writer.write(FakeOperation::picture(64, 32, i));
  writer.close();

  std::atomic<Clock::rep> begun{0};
  std::atomic<int> sent{0}, unknown{0};
  int ended = 0;
  QObject listener;
  std::unique_ptr<ui::VideoFeed> feed;
  feed = std::make_unique<ui::VideoFeed>([&](const StereoFrame& frame) {
    const auto at = feed->sent_at(frame.index);
    if (!at || at->time_since_epoch().count() < begun.load()) ++unknown;
    ++sent;
  });
  connect(feed.get(), &ui::VideoFeed::ended, &listener, [&ended] { ++ended; });
  for (int playing = 1; playing <= 2; ++playing) {
    begun = Clock::now().time_since_epoch().count();
    feed->start(engine::VideoSource{file, {}}, 0);
    QTRY_COMPARE_WITH_TIMEOUT(ended, playing, 20000);
    QCOMPARE(sent.load(), playing * kFrames);
    QCOMPARE(unknown.load(), 0);
  }
}

void GuidanceLiveTest::NothingOfTheFormerLiveViewStays() {
  reach_registration(120);
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
  post(engine::OpenCase{"other.glisson"});
  QVERIFY(!is_tracking());
  QVERIFY2(is_blank(), qPrintable(said()));
  QVERIFY2(stays_blank(), qPrintable(said()));
}

void GuidanceLiveTest::TheLiveLineTellsTheLevelAndWhy() {
  reach_registration(300);
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
  QVERIFY2(!said().contains(QStringLiteral("ONLY")) && !said().contains(QStringLiteral("NO OVERLAY")),
           qPrintable(said()));
  operation_->live_validity = Validity::partly_covered;
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("OUTLINE ONLY: part of the organ is covered")),
                           20000);
  operation_->live_validity = Validity::picture_stands;
  QTRY_VERIFY_WITH_TIMEOUT(
      said().contains(QStringLiteral("NO OVERLAY: the picture stands still. Check the camera")), 20000);
}

void GuidanceLiveTest::TimesFromTheCameraToTheScreenAreTold() {
  reach_registration(60);
  QVERIFY(rests());
  QCOMPARE(panel().live().screen_times().count(), 0);  // the registered frame is not live
  QStringList told;
  connect(&panel().live(), &ui::LiveViewModel::times_told, window_.get(),
          [&told](const ui::ScreenTimes& times) { told << QString::fromStdString(line_of(times)); });
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(words_on(panel()).contains(QStringLiteral("Camera to screen, median / 99 %")),
                           20000);
  QTRY_VERIFY_WITH_TIMEOUT(panel().live().screen_times().count() >= 3, 20000);
  QVERIFY(*panel().live().screen_times().percentile(0.5) > 0.0);
  // What is on the screen was made for it beside the window's thread.
  QTRY_VERIFY_WITH_TIMEOUT(!panel().live().on_screen().screen.isNull(), 20000);
  const ui::LivePicture& view = live_view().picture();
  QCOMPARE(panel().live().on_screen().screen.size(), view.screen_size({picture().width, picture().height}));
  QTRY_COMPARE_WITH_TIMEOUT(told.size(), qsizetype{1}, 20000);
  QVERIFY2(told.front().startsWith(QStringLiteral("camera to screen ")), qPrintable(told.front()));
}

void GuidanceLiveTest::TheRawPictureStandsBesideTheOverlay() {
  reach_registration(60);
  QVERIFY(rests());
  auto* raw = live_view().findChild<ui::PictureView*>(QStringLiteral("raw_picture"));
  QVERIFY(!raw->isVisible());
  QTest::keyClick(const_cast<ui::LivePicture*>(&live_view().picture()), Qt::Key_B);
  QVERIFY(raw->isVisible());
  const auto& frame = window_->engine().state()[part::frame]->frame;
  QTRY_VERIFY_WITH_TIMEOUT(!raw->picture().empty() && *raw->picture().bytes == *frame.left.bytes, 20000);
  QVERIFY(*raw->picture().bytes != *picture().bytes);
  QVERIFY(raw->width() > 200 && std::abs(raw->width() - live_view().picture().width()) < 4);
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
  // Both are of one moment.
  QTRY_VERIFY_WITH_TIMEOUT(
      panel().live().on_screen().raw_screen.size() == panel().live().on_screen().screen.size() &&
          raw->picture().bytes == panel().live().on_screen().raw.bytes,
      20000);
  // Also of what came while another page was shown.
  window_->show_step(MainWindow::model);
  QVERIFY(!raw->isVisible());
  QTRY_VERIFY_WITH_TIMEOUT(!is_tracking(), 20000);
  QVERIFY(rests());
  window_->show_step(MainWindow::guidance);
  QVERIFY(raw->isVisible() && raw->picture().bytes == panel().live().on_screen().raw.bytes);
  live_view().findChild<QToolButton*>(QStringLiteral("show_raw"))->click();
  QVERIFY(!raw->isVisible());
}

void GuidanceLiveTest::TheTableTellsOfEachLesion() {
  reach_registration(300);
  auto* table = panel().findChild<QTreeWidget*>(QStringLiteral("lesion_table"));
  auto* reasons = panel().findChild<QLabel*>(QStringLiteral("lesion_reasons"));
  const auto row = [table] {
    const QTreeWidgetItem* item = table->topLevelItem(0);
    return item == nullptr ? QString()
                           : item->text(0) + "|" + item->text(1) + "|" + item->text(2) + "|" + item->text(3);
  };
  QTRY_COMPARE_WITH_TIMEOUT(row(), QStringLiteral("Lesion 1|shown|2.3 mm|±5.6 mm"), 20000);
  QCOMPARE(table->topLevelItemCount(), 2);
  const QTreeWidgetItem* fork = table->topLevelItem(1);  // as the registration expects, without a verdict
  QCOMPARE(fork->text(0), QStringLiteral("Portal vein"));
  QCOMPARE(fork->text(1), QStringLiteral("fork 1"));
  QCOMPARE(fork->text(3), QStringLiteral("±8.4 mm"));
  QVERIFY(reasons->isHidden());
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
  operation_->live_validity = Validity::partly_covered;
  QTRY_COMPARE_WITH_TIMEOUT(row(), QStringLiteral("Lesion 1|region only|2.3 mm|±5.6 mm"), 20000);
  QVERIFY(reasons->text().contains(QStringLiteral("Lesion 1: as the whole overlay")));
  operation_->live_validity = Validity::picture_stands;
  QTRY_COMPARE_WITH_TIMEOUT(row(), QStringLiteral("Lesion 1|not shown|2.3 mm|±5.6 mm"), 20000);
}

void GuidanceLiveTest::LastPictureStaysUntilAnotherCaseWhateverItsStyle() {
  reach_registration(12);
  QVERIFY(rests());
  const Picture registered = picture();
  press("start_tracking");
  const auto is_marked = [this] { return said().contains(QStringLiteral("Last picture, not live")); };
  QTRY_VERIFY_WITH_TIMEOUT(is_marked() && !is_tracking(), 20000);
  QVERIFY(rests());
  const Picture without = picture_with_other_style();
  QVERIFY(!without.empty());
  QVERIFY(is_marked());
  const Picture with = picture_with_other_style();
  QVERIFY(!with.empty());
  QVERIFY(is_marked());
  QVERIFY(*with.bytes != *without.bytes);
  QVERIFY2(*with.bytes != *registered.bytes, "it is still the last one, not the registered frame");
  post(engine::OpenCase{"other.glisson"});
  QVERIFY2(is_blank(), qPrintable(said()));
}

void GuidanceLiveTest::OverTheLastPictureKeysTakeNoRegistrationBack() {
  reach_registration(12);
  QVERIFY(!do_keys_undo());
  post(engine::Register{});
  QVERIFY(do_keys_undo());
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Last picture, not live")) && !is_tracking(),
                           20000);
  QVERIFY(!do_keys_undo());
  auto* undo = panel().findChild<QPushButton*>(QStringLiteral("undo_registration"));
  QVERIFY(undo->isVisible() && undo->isEnabled());
  const auto before = window_->engine().state()[part::registration];
  undo->click();
  QTRY_VERIFY(window_->engine().state()[part::registration] != before);
  QTRY_VERIFY(do_keys_undo());  // the last picture has gone with its registration
}

void GuidanceLiveTest::OverTheLastPictureAHandSeesWhatItPlaces() {
  operation_->rival_away = 0.02;
  reach_registration(12);
  press("start_tracking");
  const auto says = [this](const char* words) { return said().contains(QLatin1String(words)); };
  QTRY_VERIFY_WITH_TIMEOUT(says("Last picture, not live") && !is_tracking(), 20000);
  QVERIFY(rests());
  const auto shows_registered = [this] {
    return panel().live().on_screen().raw.bytes == window_->engine().state()[part::frame]->frame.left.bytes;
  };
  QVERIFY(!shows_registered());
  auto* hold = panel().findChild<QPushButton*>(QStringLiteral("place_by_hand"));
  auto* choice = panel().findChild<QComboBox*>(QStringLiteral("rival"));
  const auto compare = [choice](int index) {
    choice->setCurrentIndex(index);
    emit choice->activated(index);
  };
  // Over the frame that the registration belongs to; then the last picture is back.
  hold->click();
  QTRY_VERIFY_WITH_TIMEOUT(says("Placed by hand") && !says("Last picture"), 20000);
  QVERIFY(shows_registered() && panel().live().on_screen().overlay.validity == Validity::proposed);
  hold->click();
  QTRY_VERIFY_WITH_TIMEOUT(says("Last picture, not live") && !shows_registered(), 20000);
  compare(1);
  QTRY_VERIFY_WITH_TIMEOUT(says("Other place 1") && shows_registered(), 20000);
  compare(0);
  QTRY_VERIFY_WITH_TIMEOUT(says("Last picture, not live") && !shows_registered(), 20000);
  // Nor does a former frame stay in its way.
  auto* view = const_cast<ui::LivePicture*>(&live_view().picture());
  QTest::keyClick(view, Qt::Key_Left);
  QTRY_VERIFY_WITH_TIMEOUT(says("Looked at again"), 20000);
  hold->click();
  QTRY_VERIFY_WITH_TIMEOUT(says("Placed by hand") && shows_registered(), 20000);
  QTest::keyClick(view, Qt::Key_Home);
  QTRY_VERIFY_WITH_TIMEOUT(says("Looked at again") && !shows_registered(), 20000);
  QTest::keyClick(view, Qt::Key_End);
  QTRY_VERIFY_WITH_TIMEOUT(says("Placed by hand") && shows_registered(), 20000);
}

void GuidanceLiveTest::InAPauseTheOverlayGoesWithItsRegistration() {
  reach_registration(300);
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
  QTest::keyClick(const_cast<ui::LivePicture*>(&live_view().picture()), Qt::Key_Space);
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Paused at frame")), 20000);
  QVERIFY(rests());
  const auto level = [this] { return panel().live().on_screen().overlay.level(); };
  QCOMPARE(level(), Level::valid);
  const Picture drawn = picture();
  post(engine::SetSeeds{});  // the labels, and all that was made of them, are out of date now
  QCOMPARE(window_->engine().snapshot()->stage(part::live), engine::StageState::stale);
  QVERIFY(is_tracking());
  QTRY_COMPARE_WITH_TIMEOUT(level(), Level::withdrawn, 20000);
  QVERIFY(*picture().bytes != *drawn.bytes);
  QVERIFY2(said().contains(QStringLiteral("Paused")), qPrintable(said()));
}

/// A recording and a kept moment tell what the organ's surface has said, though a proposal is drawn.
void GuidanceLiveTest::WhatIsDrawnForHandsIsKnownAsRefuted() {
  reach_registration(300);
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
  operation_->live_validity = Validity::surface_apart;
  const auto validity = [this] { return panel().live().on_screen().overlay.validity; };
  QTRY_COMPARE_WITH_TIMEOUT(validity(), Validity::surface_apart, 20000);
  QTest::keyClick(const_cast<ui::LivePicture*>(&live_view().picture()), Qt::Key_Space);
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Paused at frame")), 20000);
  QVERIFY(rests());
  auto* correct = window_->findChild<QAbstractButton*>(QStringLiteral("correct_by_hand"));
  const auto drawn_after_click = [&] {
    const int before = panel().pictures_shown();
    correct->click();
    (void)QTest::qWaitFor([&] { return panel().pictures_shown() > before && rests(); }, 20000);
    return picture();
  };
  const Picture proposed = drawn_after_click();
  QCOMPARE(validity(), Validity::surface_apart);
  const Picture withdrawn = drawn_after_click();
  const Picture again = drawn_after_click();
  const auto different = [](const Picture& a, const Picture& b) {
    return std::inner_product(a.bytes->begin(), a.bytes->end(), b.bytes->begin(), 0L, std::plus<>(),
                              std::not_equal_to<>());
  };
  // The outline is far more than words that go with the time.
  QVERIFY(different(proposed, withdrawn) > 10 * different(proposed, again));
}

void GuidanceLiveTest::APictureOfUnknownAgeIsNotLive() {
  reach_registration(12);
  post(engine::StartTracking{});
  StereoFrame frame;
  frame.left = frame.right =
      FakeOperation::picture(operation_->rig.left.width, operation_->rig.left.height, 7);
  frame.index = 7;
  window_->engine().submit_frame(frame);  // of which the feed knows nothing
  QTRY_COMPARE_WITH_TIMEOUT(panel().live().shown_index(), 7, 20000);
  QVERIFY(!panel().live().shows_live());
  QTRY_VERIFY(said().contains(QStringLiteral("Frame 7, not live")));
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::GuidanceLiveTest>(argc, argv); }
#include "guidance_live_test.moc"
