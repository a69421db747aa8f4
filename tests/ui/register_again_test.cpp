// SPDX-License-Identifier: GPL-3.0-or-later
// The organ is registered again while it is followed, with one key.
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "glisson/engine/parts/live.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/again_box.h"
#include "glisson/ui/guidance/recording_model.h"
#include "run_in_window.h"
#include "tracked_case.h"

namespace glisson {
namespace {

struct Guidance : LivePart {
  explicit Guidance(ui::EngineBridge& engine)
      : LivePart(engine), recording(worker, playback, correction, again), box(again) {
    box.show();
  }
  ui::RecordingModel recording;
  ui::AgainBox box;

  QPushButton* button(const char* name) { return box.findChild<QPushButton*>(QString::fromLatin1(name)); }
  QString said() { return box.findChild<QLabel*>(QStringLiteral("again_said"))->text(); }
};

}  // namespace

class RegisterAgainTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup();
  void OneKeyRegistersAgainAndTheBetterOneIsShown();
  void WhatIsNoBetterIsLeftToThePerson();
  void WhatIsRefusedCannotBeTaken();
  void TheSameKeyCancelsAndTheFormerOneStays();
  void AKeyThatIsHeldIsPressedOnce();
  void AnEndOfTheVideoEndsNothing();
  void WhatWasDoneStandsBesideTheRecording();

 private:
  double place_x() const { return engine().state()[part::live]->overlay.nodes_in_camera.col(0).mean(); }
  double registered_x() const { return engine().state()[part::registration]->nodes_in_camera.col(0).mean(); }
  bool is_idle() const { return engine().tasks().empty() && !guidance().again.is_running; }

  Guidance& guidance() const { return *case_->guidance; }
  ui::EngineBridge& engine() const { return *case_->engine; }

  std::unique_ptr<TrackedCase<Guidance>> case_;
};

void RegisterAgainTest::init() {
  case_ = std::make_unique<TrackedCase<Guidance>>();
  case_->register_it();
  QVERIFY(!guidance().button("register_again")->isEnabled());
  QVERIFY(!guidance().button("exchange_registration")->isEnabled());
  case_->begin_tracking();
}

void RegisterAgainTest::cleanup() { case_.reset(); }

void RegisterAgainTest::OneKeyRegistersAgainAndTheBetterOneIsShown() {
  const double before = place_x(), start = registered_x();
  QTest::keyClick(&guidance().view, Qt::Key_R);
  QTRY_VERIFY(guidance().button("exchange_registration")->isEnabled());
  QVERIFY(std::abs(place_x() - before - 3e-3) < 1e-9);
  QVERIFY(std::abs(registered_x() - start - 3e-3) < 1e-9);
  QVERIFY2(guidance().said().contains(QStringLiteral("3.0 mm")) &&
               guidance().said().contains(QStringLiteral("0.4 mm, before 1.6 mm")),
           qPrintable(guidance().said()));
  QCOMPARE(guidance().button("exchange_registration")->text(), QStringLiteral("Former one"));
  QTest::mouseClick(guidance().button("exchange_registration"), Qt::LeftButton);
  QTRY_VERIFY(std::abs(place_x() - before) < 1e-9);
  QTRY_COMPARE(guidance().button("exchange_registration")->text(), QStringLiteral("Take it"));
  QVERIFY(engine().snapshot()->tracking);
}

void RegisterAgainTest::WhatIsNoBetterIsLeftToThePerson() {
  case_->operation->again_is_better = false;
  const double before = place_x();
  QTest::mouseClick(guidance().button("register_again"), Qt::LeftButton);
  QTRY_VERIFY(guidance().button("exchange_registration")->isEnabled());
  QVERIFY(std::abs(place_x() - before) < 1e-9);
  QVERIFY2(guidance().said().startsWith(QStringLiteral("Not taken")), qPrintable(guidance().said()));
  QTest::mouseClick(guidance().button("exchange_registration"), Qt::LeftButton);
  QTRY_VERIFY(std::abs(place_x() - before - 3e-3) < 1e-9);
}

void RegisterAgainTest::WhatIsRefusedCannotBeTaken() {
  case_->operation->again_is_better = false;
  case_->operation->again_doubts = {"refused"};
  const double before = place_x();
  QTest::mouseClick(guidance().button("register_again"), Qt::LeftButton);
  QTRY_VERIFY2(guidance().said().startsWith(QStringLiteral("Not taken")), qPrintable(guidance().said()));
  QTRY_VERIFY(is_idle());
  QVERIFY(!guidance().button("exchange_registration")->isEnabled());
  guidance().again.exchange();
  QVERIFY(is_idle());
  QVERIFY(std::abs(place_x() - before) < 1e-9);
}

void RegisterAgainTest::TheSameKeyCancelsAndTheFormerOneStays() {
  case_->operation->hold = true;
  const double before = place_x();
  QTest::keyClick(&guidance().view, Qt::Key_R);
  QTRY_COMPARE(guidance().button("register_again")->text(), QStringLiteral("Cancel"));
  QVERIFY(engine().snapshot()->tracking);  // meanwhile
  QTest::keyClick(&guidance().view, Qt::Key_R);
  QTRY_VERIFY(is_idle());
  case_->operation->hold = false;
  QVERIFY(std::abs(place_x() - before) < 1e-9);
  QVERIFY(guidance().said().startsWith(QStringLiteral("Cancelled")));
  QVERIFY(!guidance().button("exchange_registration")->isEnabled());
}

void RegisterAgainTest::AKeyThatIsHeldIsPressedOnce() {
  case_->operation->hold = true;
  for (const bool repeats : {false, true})
    QTest::simulateEvent(&guidance().view, true, Qt::Key_R, {}, QStringLiteral("r"), repeats);
  QTest::keyRelease(&guidance().view, Qt::Key_R);
  QVERIFY(guidance().again.is_running);
  case_->operation->hold = false;
  QTRY_VERIFY(is_idle());
  QTRY_VERIFY2(guidance().said().startsWith(QStringLiteral("Registered again")),
               qPrintable(guidance().said()));
}

void RegisterAgainTest::AnEndOfTheVideoEndsNothing() {
  case_->operation->hold = true;
  const double start = registered_x();
  QTest::keyClick(&guidance().view, Qt::Key_R);
  QTRY_VERIFY(guidance().again.is_running);
  guidance().playback.stop();
  QTRY_VERIFY(!guidance().again.is_offered);
  QVERIFY(guidance().again.is_running);
  case_->operation->hold = false;
  QTRY_VERIFY(is_idle());
  QVERIFY2(guidance().said().startsWith(QStringLiteral("Better")), qPrintable(guidance().said()));
  QVERIFY(std::abs(registered_x() - start) < 1e-9 &&
          !guidance().button("exchange_registration")->isEnabled());
  guidance().playing.findChild<ui::TaskButton*>(QStringLiteral("start_tracking"))->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(guidance().button("exchange_registration")->isEnabled(), 20000);
  QTRY_VERIFY(engine().state()[part::live]->overlay.nodes_in_camera.rows() > 0);
  QTest::mouseClick(guidance().button("exchange_registration"), Qt::LeftButton);
  QTRY_VERIFY(std::abs(registered_x() - start - 3e-3) < 1e-9);
}

void RegisterAgainTest::WhatWasDoneStandsBesideTheRecording() {
  guidance().playback.pause(false);
  const std::filesystem::path film = case_->folder->path() / "film.mkv";
  guidance().recording.start(QString::fromStdString(film.string()));
  QTest::qWait(200);
  QTest::keyClick(&guidance().view, Qt::Key_R);
  QTRY_COMPARE(guidance().again.record().size(), std::size_t{1});
  guidance().recording.stop();
  QTRY_VERIFY(!guidance().recording.is_recording);
  QFile beside(QString::fromStdString(film.string() + ".corrections.jsonl"));
  QVERIFY(beside.open(QIODevice::ReadOnly));
  const QByteArray text = beside.readAll();
  QVERIFY2(text.contains("\"registered_again\"") && text.contains("\"taken\":true"), text.constData());
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::RegisterAgainTest>(argc, argv); }
#include "register_again_test.moc"
