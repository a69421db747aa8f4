// SPDX-License-Identifier: GPL-3.0-or-later
// Moments of the live view: kept as they are on the screen, shown as what they are, and never taken for live.
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/moments.h"
#include "glisson/patient/overlay_record.h"
#include "glisson/stereo/picture_reader.h"
#include "glisson/ui/guidance/moments_model.h"
#include "guidance_window.h"

namespace glisson {

class UiMomentsTest : public QObject, protected GuidanceWindow {
  Q_OBJECT
 private slots:
  void init() { open_window(); }
  void cleanup() { close_window(); }
  void NothingIsKeptBeforeTracking();
  void TheFrameOnTheScreenIsKeptAsItWasTaken();
  void AKeptMomentIsNeverTakenForLive();
  void AWithdrawnMomentShowsNoOverlay();
  void ARecordingGoesOnBehindAMoment();
  void AnotherModelsOverlayIsNotDrawn();
  void TitlesAndDeletionsAreTakenBack();
  void OneThatComesBackTakesAFreeNumber();
  void AnotherCaseHasNoneOfThem();
  void ATitleGoesToNoOtherCase();
  void WhatIsToldOfLesionsIsTheMoments();

 private:
  template <class T>
  T* child(const char* name) const {
    return window_->findChild<T*>(QString::fromLatin1(name));
  }
  QListWidget& list() const { return *child<QListWidget>("moments"); }
  const engine::CaseState& state() const { return window_->engine().state(); }
  std::size_t kept() const { return state()[part::moments] ? state()[part::moments]->moments.size() : 0; }
  void key(Qt::Key which) const {
    QTest::keyClick(const_cast<ui::LivePicture*>(&live_view().picture()), which);
  }
  void track() {
    press("start_tracking");
    QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
  }
  void keep(std::size_t count) {
    key(Qt::Key_K);
    QTRY_COMPARE_WITH_TIMEOUT(kept(), count, 20000);
    QTRY_COMPARE_WITH_TIMEOUT(list().count(), static_cast<int>(count), 20000);
  }
  void click_row(int row) const {
    list().scrollToItem(list().item(row));
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {},
                      list().visualItemRect(list().item(row)).center());
  }
  int frames() const { return state()[part::live] ? state()[part::live]->frames : 0; }
  static bool same_bytes(const Picture& a, const Picture& b) {
    return a.width == b.width && a.height == b.height && *a.bytes == *b.bytes;
  }
  /// Pixels in which two pictures of one size differ.
  static int differing(const Picture& a, const Picture& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.bytes->size(); ++i) count += (*a.bytes)[i] != (*b.bytes)[i] ? 1 : 0;
    return count;
  }
};

void UiMomentsTest::NothingIsKeptBeforeTracking() {
  reach_registration(60);
  auto* button = child<QPushButton>("keep_moment");
  QVERIFY(!button->isEnabled());
  QCOMPARE(button->toolTip(), QStringLiteral("Nothing is followed: start tracking, then keep a moment."));
  key(Qt::Key_K);
  QCOMPARE(child<QLabel>("moments_said")->text(), button->toolTip());
  QCOMPARE(kept(), std::size_t{0});
  QVERIFY(!list().isVisible());
}

void UiMomentsTest::TheFrameOnTheScreenIsKeptAsItWasTaken() {
  reach_registration(300);
  track();
  QTRY_VERIFY_WITH_TIMEOUT(frames() > 3, 20000);  // so that there are former ones
  key(Qt::Key_Space);
  QVERIFY(rests());
  const ui::PaintedOverlay seen = panel().live().on_screen();
  QVERIFY(child<QPushButton>("keep_moment")->isEnabled());
  QTest::mouseClick(child<QPushButton>("keep_moment"), Qt::LeftButton);
  QTRY_COMPARE_WITH_TIMEOUT(kept(), std::size_t{1}, 20000);
  const engine::KeptMoment& moment = *state()[part::moments]->moments[0];
  QCOMPARE(moment.number, 1);
  QCOMPARE(moment.overlay.index, seen.overlay.index);
  QVERIFY(moment.overlay.nodes_in_camera == seen.overlay.nodes_in_camera);
  QCOMPARE(moment.overlay.seconds, seen.overlay.seconds);
  QVERIFY(moment.camera_from_model.has_value());
  stereo::PictureReader reader;
  QVERIFY(same_bytes(reader.decode(*moment.left_png, "left"), seen.raw));
  QVERIFY(same_bytes(reader.decode(*moment.right_png, "right"), state()[part::live]->frame.right));
  QVERIFY(engine::is_drawn_as_it_was(state(), moment));
  QTRY_VERIFY_WITH_TIMEOUT(!list().item(0)->icon().isNull(), 20000);
  QVERIFY(list().item(0)->text().contains(QStringLiteral("frame %1").arg(seen.overlay.index)));
  QVERIFY(list().item(0)->text().contains(QStringLiteral("valid")));
  // A former frame has lost its raw pictures.
  key(Qt::Key_Left);
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Looked at again")), 20000);
  QVERIFY(!child<QPushButton>("keep_moment")->isEnabled());
}

void UiMomentsTest::AKeptMomentIsNeverTakenForLive() {
  reach_registration(600);
  track();
  keep(1);
  const int index = state()[part::moments]->moments[0]->overlay.index;
  QTRY_VERIFY_WITH_TIMEOUT(frames() > 0 && panel().live().shown_index() > index, 20000);
  click_row(0);
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Kept moment 1, not live")), 20000);
  QCOMPARE(panel().live().shown_index(), index);
  QVERIFY(!panel().live().shows_live());
  QVERIFY2(!said().contains(QStringLiteral("LIVE")), qPrintable(said()));
  // The live loop goes on, and nothing of it comes over the moment.
  const int followed = frames();
  QTRY_VERIFY_WITH_TIMEOUT(frames() > followed + 5, 20000);
  QVERIFY(is_tracking());
  QCOMPARE(panel().live().shown_index(), index);
  QVERIFY2(!said().contains(QStringLiteral("LIVE")), qPrintable(said()));
  const Picture shown = picture();
  QVERIFY(differing(shown, panel().live().on_screen().raw) > 100);  // its overlay is there
  // Neither is it kept once more, nor can a hand move an organ that is elsewhere by now.
  QVERIFY(!child<QPushButton>("keep_moment")->isEnabled());
  key(Qt::Key_C);
  QVERIFY(!child<QPushButton>("correct_by_hand")->isChecked());
  // Another style is another drawing of the same moment.
  QVERIFY(!same_bytes(picture_with_other_style(), shown));
  QCOMPARE(panel().live().shown_index(), index);
  key(Qt::Key_Escape);
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
  QVERIFY(!said().contains(QStringLiteral("Kept moment")));
  QVERIFY(panel().live().shown_index() > index);
  // So does a click, and the timeline's End.
  click_row(0);
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Kept moment")), 20000);
  QTest::mouseClick(child<QPushButton>("leave_moment"), Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
  click_row(0);
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Kept moment")), 20000);
  key(Qt::Key_End);
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
}

void UiMomentsTest::AWithdrawnMomentShowsNoOverlay() {
  reach_registration(600);
  track();
  operation_->live_validity = Validity::picture_stands;
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("NO OVERLAY")), 20000);
  keep(1);
  operation_->live_validity = Validity::valid;
  QTRY_VERIFY_WITH_TIMEOUT(!said().contains(QStringLiteral("NO OVERLAY")), 20000);
  const Picture live = picture(), live_raw = panel().live().on_screen().raw;
  click_row(0);
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("NO OVERLAY: the picture stands still")), 20000);
  QVERIFY(said().contains(QStringLiteral("Kept moment 1, not live")));
  QVERIFY(list().item(0)->text().contains(QStringLiteral("no overlay")));
  // Words and border are there, the organ is not: its middle is as it was taken.
  const Picture shown = picture(), raw = panel().live().on_screen().raw;
  const auto in_the_middle = [](const Picture& drawn, const Picture& taken) {
    int count = 0;
    for (int row = drawn.height * 45 / 100; row < drawn.height * 55 / 100; ++row)
      for (int byte = drawn.width * 3 / 4; byte < drawn.width * 9 / 4; ++byte) {
        const auto at = static_cast<std::size_t>(row * drawn.width * 3 + byte);
        count += (*drawn.bytes)[at] != (*taken.bytes)[at] ? 1 : 0;
      }
    return count;
  };
  QCOMPARE(in_the_middle(shown, raw), 0);
  QVERIFY(in_the_middle(live, live_raw) > 0);
}

void UiMomentsTest::ARecordingGoesOnBehindAMoment() {
  reach_registration(600);
  track();
  const std::filesystem::path film = folder_->path() / "film.mkv";
  panel().record_to(QString::fromStdString(film.string()));
  keep(1);
  click_row(0);
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Kept moment 1")), 20000);
  const int shown_at = state()[part::live]->overlay.index;
  QTRY_VERIFY_WITH_TIMEOUT(state()[part::live]->overlay.index > shown_at + 20, 20000);
  panel().record_to({});
  const std::filesystem::path lines = folder_->path() / "film.frames.jsonl";
  QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(lines) && std::filesystem::exists(film), 20000);
  int behind = 0;
  for (const OverlayLine& line : read_overlay_record(lines).frames) behind += line.number > shown_at ? 1 : 0;
  QVERIFY(behind > 3);
}

void UiMomentsTest::AnotherModelsOverlayIsNotDrawn() {
  reach_registration(300);
  track();
  keep(1);
  child<QPushButton>("stop_tracking")->click();
  QTRY_VERIFY_WITH_TIMEOUT(!is_tracking(), 20000);
  post(engine::BuildModel{});
  click_row(0);
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("made anew since")), 20000);
  QVERIFY(same_bytes(picture(), panel().live().on_screen().raw));
}

void UiMomentsTest::TitlesAndDeletionsAreTakenBack() {
  reach_registration(300);
  track();
  keep(1);
  keep(2);
  QVERIFY(list().item(0)->text().startsWith(QStringLiteral("Moment 2")));  // the newest first
  list().setCurrentRow(1);
  auto* title = child<QLineEdit>("moment_title");
  title->setFocus();
  QTest::keyClicks(title, QStringLiteral("Kante"));
  QTest::keyClick(title, Qt::Key_Return);
  QTRY_COMPARE_WITH_TIMEOUT(state()[part::moments]->moments[0]->title, std::string("Kante"), 20000);
  QTRY_VERIFY_WITH_TIMEOUT(list().item(1)->text().startsWith(QStringLiteral("1: Kante")), 20000);
  QTest::mouseClick(child<QPushButton>("remove_moment"), Qt::LeftButton);
  QTRY_COMPARE_WITH_TIMEOUT(kept(), std::size_t{1}, 20000);
  auto* undo = child<QPushButton>("undo_moments");
  QTest::mouseClick(undo, Qt::LeftButton);
  QTRY_COMPARE_WITH_TIMEOUT(kept(), std::size_t{2}, 20000);
  QCOMPARE(state()[part::moments]->moments[0]->title, std::string("Kante"));
  QTest::mouseClick(undo, Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(state()[part::moments]->moments[0]->title.empty(), 20000);
  QVERIFY(!undo->isEnabled());
}

void UiMomentsTest::OneThatComesBackTakesAFreeNumber() {
  reach_registration(300);
  track();
  keep(1);
  list().setCurrentRow(0);
  QTest::mouseClick(child<QPushButton>("remove_moment"), Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(!state()[part::moments], 20000);
  keep(1);  // numbers begin anew
  const double seconds = state()[part::moments]->moments[0]->overlay.seconds;
  QTest::mouseClick(child<QPushButton>("undo_moments"), Qt::LeftButton);
  QTRY_COMPARE_WITH_TIMEOUT(kept(), std::size_t{2}, 20000);
  QCOMPARE(state()[part::moments]->moments[0]->overlay.seconds, seconds);
  QCOMPARE(state()[part::moments]->moments[1]->number, 2);
}

void UiMomentsTest::AnotherCaseHasNoneOfThem() {
  reach_registration(300);
  track();
  keep(1);
  click_row(0);
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Kept moment 1")), 20000);
  post(engine::OpenCase{"other.glisson"});
  QTRY_VERIFY_WITH_TIMEOUT(!list().isVisible(), 20000);
  QVERIFY2(is_blank(), qPrintable(said()));
  QVERIFY2(stays_blank(), qPrintable(said()));
  QVERIFY(!panel().live().shows_kept());
}

void UiMomentsTest::ATitleGoesToNoOtherCase() {
  reach_registration(300);
  track();
  keep(1);
  list().setCurrentRow(0);
  auto* title = child<QLineEdit>("moment_title");
  title->setFocus();
  QTest::keyClicks(title, QStringLiteral("Kante"));
  moments_of_other_ = std::make_shared<const engine::KeptMoments>(*state()[part::moments]);
  post(engine::OpenCase{"other.glisson"});
  QCOMPARE(kept(), std::size_t{1});
  QCOMPARE(list().count(), 1);
  QCOMPARE(list().currentRow(), -1);
  QVERIFY2(title->text().isEmpty(), qPrintable(title->text()));
  QTest::keyClick(title, Qt::Key_Return);
  QTest::qWait(100);
  QVERIFY(window_->engine().tasks().empty());
  QVERIFY(state()[part::moments]->moments[0]->title.empty());
}

void UiMomentsTest::WhatIsToldOfLesionsIsTheMoments() {
  reach_registration(300);
  track();
  keep(1);
  child<QPushButton>("stop_tracking")->click();
  QTRY_VERIFY_WITH_TIMEOUT(!is_tracking(), 20000);
  operation_->doubts = {"refused", "cloud_noisy 6.3 6"};
  post(engine::Register{});
  const auto* table = child<QTreeWidget>("lesion_table");
  const auto row = [table] {
    const QTreeWidgetItem* item = table->topLevelItem(0);
    return item == nullptr ? QString() : item->text(1) + "|" + item->text(2) + "|" + item->text(3);
  };
  QTRY_COMPARE_WITH_TIMEOUT(row(), QStringLiteral("not shown||–"), 20000);
  click_row(0);
  QTRY_COMPARE_WITH_TIMEOUT(row(), QStringLiteral("shown|3.2 mm|±5.6 mm"), 20000);
  QCOMPARE(table->topLevelItemCount(), 1);  // no forks, of which a moment knows nothing
  key(Qt::Key_Escape);
  QTRY_COMPARE_WITH_TIMEOUT(row(), QStringLiteral("not shown||–"), 20000);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::UiMomentsTest>(argc, argv); }
#include "moments_test.moc"
