// SPDX-License-Identifier: GPL-3.0-or-later
// The switch that tells other programs, with a peer made with the library at the other end.
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QTest>

#include "../openigtlink/peer_process.h"
#include "fake_operation.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/stop_tracking.h"
#include "glisson/engine/parts/live.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/openigtlink_box.h"
#include "live_part.h"
#include "run_in_window.h"

namespace glisson {

class OpenIgtLinkBoxTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup();
  void ItIsOffAndAtThisComputer();
  void WhatIsTrackedIsTold();
  void AnOldFrameIsNotToldAsValid();
  void SwitchedOffItClosesAndWithdraws();
  void WhatCannotBeListenedAtIsSaid();
  void OtherComputersAreWarnedOf();

 private:
  template <class Widget>
  Widget* part_of_box(const char* name) const {
    return box_->findChild<Widget*>(QString::fromLatin1(name));
  }
  QCheckBox* on() const { return part_of_box<QCheckBox>("openigtlink_on"); }
  QString said() const { return part_of_box<QLabel>("openigtlink_said")->text(); }
  /// By hand, as a person would.
  void switch_on(const QString& address) {
    part_of_box<QLineEdit>("openigtlink_address")->setText(address);
    on()->click();
  }
  QString port() const { return model_->address.value().section(':', -1); }
  /// Frames go in until what the other process said holds.
  Words wait(PeerProcess& peer, const std::function<bool(const Words&)>& holds) {
    Words found;
    const bool came = QTest::qWaitFor(
        [&] {
          found = peer.look_for(holds);
          return !found.isEmpty();
        },
        20000);
    return came ? found : Words();
  }
  void track() {
    for (const engine::Command& step : operation_->steps_to_cloud(folder_->path() / "scope.mkv", 60))
      engine_->post(step);
    engine_->post(engine::Register{});
    QVERIFY(
        QTest::qWaitFor([this] { return engine_->tasks().empty() && live_->drawables.drawable(); }, 20000));
    live_->playback.repeats = true;
    live_->playing.findChild<ui::TaskButton*>("start_tracking")->trigger();
    QTRY_VERIFY(live_->playback.is_playing);
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<FakeOperation> operation_;
  std::unique_ptr<ui::EngineBridge> engine_;
  std::unique_ptr<LivePart> live_;
  std::unique_ptr<ui::OpenIgtLinkModel> model_;
  std::unique_ptr<ui::OpenIgtLinkBox> box_;
};

void OpenIgtLinkBoxTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  operation_ = std::make_unique<FakeOperation>();
  make_box_operation(*operation_);
  engine_ = std::make_unique<ui::EngineBridge>(operation_->options());
  live_ = std::make_unique<LivePart>(*engine_);
  model_ = std::make_unique<ui::OpenIgtLinkModel>(*engine_, live_->drawables);
  box_ = std::make_unique<ui::OpenIgtLinkBox>(*model_);
}

void OpenIgtLinkBoxTest::cleanup() {
  box_.reset();
  model_.reset();
  live_.reset();
  engine_.reset();
  operation_.reset();
  folder_.reset();
}

void OpenIgtLinkBoxTest::ItIsOffAndAtThisComputer() {
  QVERIFY(!on()->isChecked() && !model_->is_on);
  QCOMPARE(part_of_box<QLineEdit>("openigtlink_address")->text(), QString("127.0.0.1:18944"));
  QCOMPARE(said(), QString());
}

void OpenIgtLinkBoxTest::WhatIsTrackedIsTold() {
  track();
  switch_on("127.0.0.1:0");
  QVERIFY(on()->isChecked());
  QVERIFY(!part_of_box<QLineEdit>("openigtlink_address")->isEnabled());
  PeerProcess peer({"listen", port()});
  QVERIFY(!wait(peer, [](const Words& words) {
             return words.value(0) == "POLYDATA" && words.value(1) == "parenchyma" &&
                    words.value(3).toInt() > 3;
           }).isEmpty());
  QTRY_VERIFY2(said().endsWith("connected: 1"), qPrintable(said()));
  operation_->live_validity = Validity::picture_stands;
  QVERIFY(
      !wait(peer, [](const Words& words) { return words.value(4) == "reason=picture_stands"; }).isEmpty());
  operation_->live_validity = Validity::valid;
  QVERIFY(!wait(peer, [](const Words& words) { return words.value(4) == "reason=valid"; }).isEmpty());
  live_->playback.stop();  // what is over is not told as going on
  QVERIFY(!wait(peer, [](const Words& words) { return words.value(4) == "reason=not_started"; }).isEmpty());
  QVERIFY(!wait(peer, [](const Words& words) {
             return words.value(0) == "POLYDATA" && words.value(3) == "0" && words.value(1) == "parenchyma";
           }).isEmpty());
}

void OpenIgtLinkBoxTest::AnOldFrameIsNotToldAsValid() {
  track();
  QTRY_VERIFY(engine_->state()[part::live] &&
              engine_->state()[part::live]->overlay.validity == Validity::valid);
  live_->playback.pause(true);
  // Frames that were on their way have come when nothing has changed for a while.
  for (int last = -1; last != engine_->state()[part::live]->overlay.index; QTest::qWait(300))
    last = engine_->state()[part::live]->overlay.index;
  switch_on("127.0.0.1:0");
  PeerProcess peer({"listen", port()});
  const Words first = wait(peer, [](const Words& words) { return words.value(0) == "STRING"; });
  QVERIFY2(first.value(4) == "reason=stale", qPrintable(first.join(' ')));
  live_->playback.pause(false);
  QVERIFY(!wait(peer, [](const Words& words) { return words.value(4) == "reason=valid"; }).isEmpty());
}

void OpenIgtLinkBoxTest::SwitchedOffItClosesAndWithdraws() {
  track();
  switch_on("127.0.0.1:0");
  PeerProcess peer({"listen", port()});
  QVERIFY(!wait(peer, [](const Words& words) { return words.value(0) == "TRANSFORM"; }).isEmpty());
  on()->click();
  QVERIFY(!on()->isChecked() && !model_->is_on);
  QCOMPARE(said(), QString());
  QCOMPARE(peer.all().back().value(3), QString("0"));  // an empty surface, and then the end
  QVERIFY(part_of_box<QLineEdit>("openigtlink_address")->isEnabled());
}

void OpenIgtLinkBoxTest::WhatCannotBeListenedAtIsSaid() {
  openigtlink::SenderOptions options;
  options.address.port = 0;
  const openigtlink::Sender other(options);
  switch_on(QString::fromStdString(other.address().text()));
  QVERIFY(!on()->isChecked() && !model_->is_on);
  QVERIFY2(said().contains("another program"), qPrintable(said()));
  QCOMPARE(model_->tone.value(), QString("error"));
  switch_on("slicer");
  QVERIFY2(said().contains("127.0.0.1:18944"), qPrintable(said()));
  switch_on("127.0.0.1:0");
  QVERIFY(on()->isChecked());
}

void OpenIgtLinkBoxTest::OtherComputersAreWarnedOf() {
  switch_on("0.0.0.0:0");
  QVERIFY(on()->isChecked());
  QCOMPARE(model_->tone.value(), QString("warning"));
  QVERIFY(said().contains("encrypted"));
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::OpenIgtLinkBoxTest>(argc, argv); }
#include "openigtlink_box_test.moc"
