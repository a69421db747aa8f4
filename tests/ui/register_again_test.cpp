// SPDX-License-Identifier: GPL-3.0-or-later
// The organ is registered again while it is followed, with one key.
#include <QLabel>
#include <QPushButton>
#include <QtTest>

#include "fake_operation.h"
#include "glisson/engine/parts/live.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/again_box.h"
#include "glisson/ui/guidance/recording_model.h"
#include "live_part.h"
#include "run_in_window.h"

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
  void TheSameKeyCancelsAndTheFormerOneStays();
  void AnEndOfTheVideoEndsNothing();
  void WhatWasDoneStandsBesideTheRecording();

 private:
  double place_x() const { return engine_->state()[part::live]->overlay.nodes_in_camera.col(0).mean(); }
  double registered_x() const { return engine_->state()[part::registration]->nodes_in_camera.col(0).mean(); }
  bool is_idle() const { return engine_->tasks().empty() && !guidance_->again.is_running; }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<FakeOperation> operation_;
  std::unique_ptr<ui::EngineBridge> engine_;
  std::unique_ptr<Guidance> guidance_;
};

void RegisterAgainTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  operation_ = std::make_unique<FakeOperation>();
  make_box_operation(*operation_);
  engine_ = std::make_unique<ui::EngineBridge>(operation_->options());
  for (const engine::Command& step : operation_->steps_to_cloud(folder_->path() / "scope.mkv", 60))
    engine_->post(step);
  engine_->post(engine::Register{});
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  guidance_ = std::make_unique<Guidance>(*engine_);
  QTRY_VERIFY_WITH_TIMEOUT(guidance_->drawables.drawable() != nullptr, 20000);
  QVERIFY(!guidance_->button("register_again")->isEnabled());
  QVERIFY(!guidance_->button("exchange_registration")->isEnabled());
  guidance_->playing.findChild<ui::TaskButton*>(QStringLiteral("start_tracking"))->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(guidance_->live.line.value().startsWith(QStringLiteral("LIVE")), 20000);
  guidance_->playback.pause(true);
  QTest::qWait(200);
}

void RegisterAgainTest::cleanup() {
  guidance_.reset();
  engine_.reset();
  operation_.reset();
  folder_.reset();
}

void RegisterAgainTest::OneKeyRegistersAgainAndTheBetterOneIsShown() {
  const double before = place_x(), start = registered_x();
  QTest::keyClick(&guidance_->view, Qt::Key_R);
  QTRY_VERIFY(guidance_->button("exchange_registration")->isEnabled());
  QVERIFY(std::abs(place_x() - before - 3e-3) < 1e-9);
  QVERIFY(std::abs(registered_x() - start - 3e-3) < 1e-9);
  QVERIFY2(guidance_->said().contains(QStringLiteral("3.0 mm")) &&
               guidance_->said().contains(QStringLiteral("0.4 mm, before 1.6 mm")),
           qPrintable(guidance_->said()));
  QCOMPARE(guidance_->button("exchange_registration")->text(), QStringLiteral("Former one"));
  QTest::mouseClick(guidance_->button("exchange_registration"), Qt::LeftButton);
  QTRY_VERIFY(std::abs(place_x() - before) < 1e-9);
  QTRY_COMPARE(guidance_->button("exchange_registration")->text(), QStringLiteral("Take it"));
  QVERIFY(engine_->snapshot()->tracking);
}

void RegisterAgainTest::WhatIsNoBetterIsLeftToThePerson() {
  operation_->again_is_better = false;
  const double before = place_x();
  QTest::mouseClick(guidance_->button("register_again"), Qt::LeftButton);
  QTRY_VERIFY(guidance_->button("exchange_registration")->isEnabled());
  QVERIFY(std::abs(place_x() - before) < 1e-9);
  QVERIFY2(guidance_->said().startsWith(QStringLiteral("Not taken")), qPrintable(guidance_->said()));
  QTest::mouseClick(guidance_->button("exchange_registration"), Qt::LeftButton);
  QTRY_VERIFY(std::abs(place_x() - before - 3e-3) < 1e-9);
}

void RegisterAgainTest::TheSameKeyCancelsAndTheFormerOneStays() {
  operation_->hold = true;
  const double before = place_x();
  QTest::keyClick(&guidance_->view, Qt::Key_R);
  QTRY_COMPARE(guidance_->button("register_again")->text(), QStringLiteral("Cancel"));
  QVERIFY(engine_->snapshot()->tracking);  // meanwhile
  QTest::keyClick(&guidance_->view, Qt::Key_R);
  QTRY_VERIFY(is_idle());
  operation_->hold = false;
  QVERIFY(std::abs(place_x() - before) < 1e-9);
  QVERIFY(guidance_->said().startsWith(QStringLiteral("Cancelled")));
  QVERIFY(!guidance_->button("exchange_registration")->isEnabled());
}

void RegisterAgainTest::AnEndOfTheVideoEndsNothing() {
  operation_->hold = true;
  const double start = registered_x();
  QTest::keyClick(&guidance_->view, Qt::Key_R);
  QTRY_VERIFY(guidance_->again.is_running);
  guidance_->playback.stop();
  QTRY_VERIFY(!guidance_->again.is_offered);
  QVERIFY(guidance_->again.is_running);
  operation_->hold = false;
  QTRY_VERIFY(is_idle());
  QVERIFY2(guidance_->said().startsWith(QStringLiteral("Better")), qPrintable(guidance_->said()));
  QVERIFY(std::abs(registered_x() - start) < 1e-9 &&
          !guidance_->button("exchange_registration")->isEnabled());
  guidance_->playing.findChild<ui::TaskButton*>(QStringLiteral("start_tracking"))->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(guidance_->button("exchange_registration")->isEnabled(), 20000);
  QTRY_VERIFY(engine_->state()[part::live]->overlay.nodes_in_camera.rows() > 0);
  QTest::mouseClick(guidance_->button("exchange_registration"), Qt::LeftButton);
  QTRY_VERIFY(std::abs(registered_x() - start - 3e-3) < 1e-9);
}

void RegisterAgainTest::WhatWasDoneStandsBesideTheRecording() {
  guidance_->playback.pause(false);
  const std::filesystem::path film = folder_->path() / "film.mkv";
  guidance_->recording.start(QString::fromStdString(film.string()));
  QTest::qWait(200);
  QTest::keyClick(&guidance_->view, Qt::Key_R);
  QTRY_COMPARE(guidance_->again.record().size(), std::size_t{1});
  guidance_->recording.stop();
  QTRY_VERIFY(!guidance_->recording.is_recording);
  QFile beside(QString::fromStdString(film.string() + ".corrections.jsonl"));
  QVERIFY(beside.open(QIODevice::ReadOnly));
  const QByteArray text = beside.readAll();
  QVERIFY2(text.contains("\"registered_again\"") && text.contains("\"taken\":true"), text.constData());
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::RegisterAgainTest>(argc, argv); }
#include "register_again_test.moc"
