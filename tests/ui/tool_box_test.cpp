// SPDX-License-Identifier: GPL-3.0-or-later
// A tracked tool from a server made with the library, while the organ is followed. The organ's near face lies
// at 110 mm, the tip over its middle.
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTest>

#include "../openigtlink/peer_process.h"
#include "fake_operation.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/correct_tracking.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/parts/live.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/tool_box.h"
#include "live_part.h"
#include "run_in_window.h"

namespace glisson {

class ToolBoxTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup();
  void ItIsOff();
  void DistancesAreTold();
  void TipThatTouchesMarksThePlace();
  void RoughlyKnownPlacesGiveRoughDistances();
  void ATipInsideTheOrganIsToldSo();
  void NothingIsMeasuredToAPausedOrFormerPicture();
  void NothingIsMeasuredToAPictureThatHasStoppedComing();
  void WithdrawnOrgansAreNotMeasured();
  void WhatGoesWrongIsSaid();

 private:
  template <class Widget>
  Widget* part_of_box(const char* name) const {
    return box_->findChild<Widget*>(QString::fromLatin1(name));
  }
  QCheckBox* on() const { return part_of_box<QCheckBox>("tool_on"); }
  QString said() const { return part_of_box<QLabel>("tool_said")->text(); }
  void switch_on(const QString& address) {
    part_of_box<QLineEdit>("tool_address")->setText(address);
    on()->click();
  }
  /// The tool at 10, -20, z mm in the left camera's frame.
  void serve(const QString& kind) {
    server_ = std::make_unique<PeerProcess>(QStringList{"serve", kind});
    const Words words = server_->wait_for([](const Words& line) { return line.value(0) == "port"; });
    switch_on(QStringLiteral("127.0.0.1:%1/Tip").arg(words.value(1)));
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
    live_->live.choose(structure::kFirstLesion);
  }
  /// Millimetres after these words in what is said; -1: they are not there.
  double told(const QString& words) const {
    const auto found = QRegularExpression(words + ": ([0-9.]+) mm").match(said());
    return found.hasMatch() ? found.captured(1).toDouble() : -1.0;
  }
  bool is_place_told() const {
    const auto rows = live_->live.numbers.value();
    return std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.first.contains("mark"); });
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<FakeOperation> operation_;
  std::unique_ptr<ui::EngineBridge> engine_;
  std::unique_ptr<LivePart> live_;
  std::unique_ptr<PeerProcess> server_;
  std::unique_ptr<ui::ToolModel> model_;
  std::unique_ptr<ui::ToolBox> box_;
};

void ToolBoxTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  operation_ = std::make_unique<FakeOperation>();
  make_box_operation(*operation_);
  engine_ = std::make_unique<ui::EngineBridge>(operation_->options());
  live_ = std::make_unique<LivePart>(*engine_);
  model_ = std::make_unique<ui::ToolModel>(*engine_, live_->drawables, live_->playback, live_->review,
                                           live_->live);
  box_ = std::make_unique<ui::ToolBox>(*model_);
}

void ToolBoxTest::cleanup() {
  box_.reset();
  model_.reset();
  server_.reset();
  live_.reset();
  engine_.reset();
  operation_.reset();
  folder_.reset();
}

void ToolBoxTest::ItIsOff() {
  QVERIFY(!on()->isChecked() && !model_->is_on);
  QCOMPARE(said(), QString());
}

void ToolBoxTest::DistancesAreTold() {
  track();
  serve("z100");
  QTRY_VERIFY2(told("surface") > 0.0, qPrintable(said()));
  QVERIFY2(std::abs(told("surface") - 10.0) < 1.5, qPrintable(said()));
  QTRY_VERIFY2(told("Tip to [^:]*1") > told("surface"), qPrintable(said()));
  QVERIFY(!is_place_told());  // it does not touch
}

void ToolBoxTest::TipThatTouchesMarksThePlace() {
  track();
  serve("z107");
  QTRY_VERIFY2(is_place_told(), qPrintable(said()));
  QVERIFY2(std::abs(told("surface") - 3.0) < 1.5, qPrintable(said()));
  on()->click();
  QVERIFY(!on()->isChecked());
  QTRY_VERIFY(!is_place_told());
}

void ToolBoxTest::RoughlyKnownPlacesGiveRoughDistances() {
  track();
  serve("z100");
  QTRY_VERIFY2(told("Tip to [^:]*1") > 0.0, qPrintable(said()));
  QCOMPARE(model_->tone.value(), QString("good"));
  operation_->live_validity = Validity::partly_covered;
  const QRegularExpression rough("surface: 10 mm\nTip to [^:]*1: [0-9]+ mm \\(±6 mm\\)$");
  QTRY_VERIFY2(said().contains(rough), qPrintable(said()));
  QCOMPARE(model_->tone.value(), QString("warning"));
}

void ToolBoxTest::ATipInsideTheOrganIsToldSo() {
  track();
  serve("z113");
  const QRegularExpression inside("Tip inside the organ, ([0-9.]+) mm below its surface");
  QTRY_VERIFY2(said().contains(inside), qPrintable(said()));
  QVERIFY2(std::abs(inside.match(said()).captured(1).toDouble() - 3.0) < 1.5, qPrintable(said()));
  QCOMPARE(told("surface"), -1.0);
}

void ToolBoxTest::NothingIsMeasuredToAPausedOrFormerPicture() {
  track();
  serve("z107");
  QTRY_VERIFY2(told("surface") > 0.0 && is_place_told(), qPrintable(said()));
  live_->playback.pause(true);
  QTRY_VERIFY2(said().contains("the video is paused"), qPrintable(said()));
  QVERIFY(told("surface") < 0.0);
  QCOMPARE(model_->tone.value(), QString("warning"));
  live_->playback.pause(false);
  QTRY_VERIFY2(told("surface") > 0.0, qPrintable(said()));
  QTRY_VERIFY(live_->review.is_offered);
  live_->review.seek(live_->review.first);
  QTRY_VERIFY2(said().contains("a former moment"), qPrintable(said()));
  live_->review.go_live();
  QTRY_VERIFY2(told("surface") > 0.0, qPrintable(said()));
  live_->moments.keep();
  QTRY_COMPARE(live_->moments.rows.value().size(), std::size_t{1});
  live_->moments.show(1);
  QTRY_VERIFY2(said().contains("a former moment"), qPrintable(said()));
  live_->moments.go_live();
  QTRY_VERIFY2(told("surface") > 0.0, qPrintable(said()));
}

void ToolBoxTest::NothingIsMeasuredToAPictureThatHasStoppedComing() {
  track();
  serve("z100");
  QTRY_VERIFY2(told("surface") > 0.0, qPrintable(said()));
  live_->playback.set_speed(1e-3);  // the source stalls
  QTRY_VERIFY2(said().contains(QRegularExpression("the last picture is [0-9.]+ s old")), qPrintable(said()));
  QVERIFY(engine_->snapshot()->tracking && told("surface") < 0.0);
  // What a hand says changes the live part, and makes its picture no younger.
  engine_->post(engine::CorrectTracking{});
  QTRY_VERIFY(engine_->tasks().empty());
  QTRY_COMPARE(engine_->state()[part::live]->corrections.size(), std::size_t{1});
  QTest::qWait(250);
  QVERIFY2(said().contains("s old"), qPrintable(said()));
}

void ToolBoxTest::WithdrawnOrgansAreNotMeasured() {
  operation_->live_validity = Validity::surface_apart;
  track();
  serve("z107");
  QTRY_VERIFY2(said().contains("not followed"), qPrintable(said()));
  QVERIFY(!is_place_told());
}

void ToolBoxTest::WhatGoesWrongIsSaid() {
  switch_on("127.0.0.1:18944");
  QVERIFY(!on()->isChecked());
  QCOMPARE(model_->tone.value(), QString("error"));
  switch_on("127.0.0.1:1/Tip");
  QTRY_VERIFY2(said().contains("no server of OpenIGTLink answers"), qPrintable(said()));
  QVERIFY(!on()->isChecked() && !model_->is_on);
  serve("nan");
  QTRY_VERIFY2(said().contains("no pose of this tool"), qPrintable(said()));
  server_.reset();
  QTRY_VERIFY2(said().contains("closed the connection"), qPrintable(said()));
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::ToolBoxTest>(argc, argv); }
#include "tool_box_test.moc"
