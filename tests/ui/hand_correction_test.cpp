// SPDX-License-Identifier: GPL-3.0-or-later
// A hand drags a place of the drawn organ to where the picture shows it.
#include <QCoreApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QTest>

#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/model.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/correction_box.h"
#include "glisson/ui/guidance/recording_model.h"
#include "run_in_window.h"
#include "tracked_case.h"

namespace glisson {
namespace {

struct Guidance : LivePart {
  explicit Guidance(ui::EngineBridge& engine)
      : LivePart(engine), recording(worker, playback, correction, again), box(correction) {
    box.show();
  }
  ui::RecordingModel recording;
  ui::CorrectionBox box;

  QPushButton* button(const char* name) { return box.findChild<QPushButton*>(QString::fromLatin1(name)); }
};

}  // namespace

class HandCorrectionTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup();
  void ADragWithShiftMovesTheOrganAndUndoTakesItBack();
  void TheOrganFollowsWhileTheHandStillDrags();
  void TheButtonAndTheKeyBeginAndEnd();
  void WhatIsNotTheOrganIsNotTakenHoldOf();
  void ARefusedDragSaysWhyAndChangesNothing();
  void AFrameThatFailsWhileTheHandHoldsEndsTheDrag();
  void EscapeLeavesNothing();
  void AHandThatHasGivenUpMovesNothing();
  void NothingIsCorrectedOfAFormerFrame();
  void FormerFramesAreNotDrawnByAnotherCalibration();
  void WhatWasSaidAndChosenIsOfItsCase();
  void CorrectionsStandBesideTheRecording();

 private:
  const engine::LiveState& live() const { return *engine().state()[part::live]; }
  double place_x() const { return live().overlay.nodes_in_camera.col(0).mean(); }
  /// Pixel at which the place that was taken hold of last is drawn.
  double drawn_x() const {
    const TetMesh& mesh = case_->operation->model.mesh;
    const Eigen::Vector3d place =
        bind_points(mesh, live().corrections.back().correction.place_in_ct.transpose())
            .apply(mesh, live().overlay.nodes_in_camera)
            .row(0)
            .transpose();
    return case_->operation->rig.left.project(place).x();
  }
  bool is_drawn_at(double right) const { return std::abs(drawn_x() - 150.0 - right) < 2.5; }
  std::size_t standing() const { return live().corrections.size(); }
  QPoint at(double right) { return guidance().picture()->widget_point({150.0 + right, 90.0}).toPoint(); }
  void move(double right) {
    QMouseEvent event(QEvent::MouseMove, at(right), guidance().picture()->mapToGlobal(at(right)),
                      Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(guidance().picture(), &event);
  }
  void drag(double right, Qt::KeyboardModifiers keys) {
    QTest::mousePress(guidance().picture(), Qt::LeftButton, keys, at(0.0));
    move(0.5 * right);
    QTest::mouseRelease(guidance().picture(), Qt::LeftButton, keys, at(right));
    QVERIFY(
        QTest::qWaitFor([this] { return engine().tasks().empty() && !guidance().correction.line.value(); }));
  }

  Guidance& guidance() const { return *case_->guidance; }
  ui::EngineBridge& engine() const { return *case_->engine; }

  std::unique_ptr<TrackedCase<Guidance>> case_;
};

void HandCorrectionTest::init() {
  case_ = std::make_unique<TrackedCase<Guidance>>();
  case_->register_it();
  QVERIFY(!guidance().button("correct_by_hand")->isEnabled());
  case_->begin_tracking();
}

void HandCorrectionTest::cleanup() { case_.reset(); }

void HandCorrectionTest::ADragWithShiftMovesTheOrganAndUndoTakesItBack() {
  const double before = place_x();
  QVERIFY(!guidance().button("undo_correction")->isEnabled());
  drag(12.0, Qt::ShiftModifier);
  QCOMPARE(standing(), std::size_t{1});
  QVERIFY2(is_drawn_at(12.0), qPrintable(QString::number(drawn_x())));
  QVERIFY(guidance().correction.said.value().startsWith(QStringLiteral("Corrected by hand: 1.")));
  const double once = place_x();
  drag(-5.0, Qt::ShiftModifier);
  QCOMPARE(standing(), std::size_t{2});
  QTest::keyClick(&guidance().view, Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(standing(), std::size_t{1});
  QVERIFY(std::abs(place_x() - once) < 1e-9);
  QTRY_VERIFY(guidance().button("undo_correction")->isEnabled());
  QTest::mouseClick(guidance().button("undo_correction"), Qt::LeftButton);
  QTRY_COMPARE(standing(), std::size_t{0});
  QVERIFY(std::abs(place_x() - before) < 1e-9);
  QTRY_VERIFY(!guidance().button("undo_correction")->isEnabled());
  // Two were made, two taken back.
  QTRY_COMPARE(guidance().correction.record().size(), std::size_t{4});
}

void HandCorrectionTest::TheOrganFollowsWhileTheHandStillDrags() {
  QTest::mousePress(guidance().picture(), Qt::LeftButton, Qt::ShiftModifier, at(0.0));
  QVERIFY(guidance().correction.line.value().has_value());
  QTest::qWait(300);
  move(10.0);
  QTRY_COMPARE(standing(), std::size_t{1});
  QVERIFY(is_drawn_at(10.0));
  QTest::qWait(300);
  move(20.0);
  QTRY_VERIFY(is_drawn_at(20.0));
  QTest::mouseRelease(guidance().picture(), Qt::LeftButton, Qt::ShiftModifier, at(16.0));
  QTRY_VERIFY(!guidance().correction.line.value());
  QVERIFY(is_drawn_at(16.0));
  QCOMPARE(standing(), std::size_t{1});  // one gesture
  QCOMPARE(guidance().correction.record().size(), std::size_t{1});
}

void HandCorrectionTest::TheButtonAndTheKeyBeginAndEnd() {
  QTest::mouseClick(guidance().button("correct_by_hand"), Qt::LeftButton);
  QVERIFY(guidance().correction.is_correcting);
  drag(6.0, Qt::NoModifier);
  QCOMPARE(standing(), std::size_t{1});
  QTest::keyClick(&guidance().view, Qt::Key_C);
  QVERIFY(!guidance().correction.is_correcting && !guidance().button("correct_by_hand")->isChecked());
  drag(6.0, Qt::NoModifier);
  QCOMPARE(standing(), std::size_t{1});
}

void HandCorrectionTest::WhatIsNotTheOrganIsNotTakenHoldOf() {
  QVERIFY(!guidance().correction.grab({3.0, 3.0}));
  QVERIFY(!guidance().correction.line.value());
  QCOMPARE(guidance().correction.tone.value(), QStringLiteral("warning"));
  case_->operation->live_validity = Validity::surface_apart;
  guidance().playback.step();
  QTRY_COMPARE(live().overlay.validity, Validity::surface_apart);
  QVERIFY(!guidance().correction.grab({150.0, 90.0}));  // nothing is drawn
  guidance().correction.is_correcting = true;           // shows where it is believed to be
  QVERIFY(guidance().correction.grab({150.0, 90.0}));
  guidance().correction.give_up();
}

void HandCorrectionTest::ARefusedDragSaysWhyAndChangesNothing() {
  const double before = place_x();
  drag(130.0, Qt::ShiftModifier);
  QCOMPARE(standing(), std::size_t{0});
  QCOMPARE(guidance().correction.tone.value(), QStringLiteral("error"));
  QVERIFY(guidance().correction.said.value().contains(QStringLiteral("outside of the picture")));
  QCOMPARE(place_x(), before);
  QVERIFY(guidance().correction.record().empty());
  QVERIFY(engine().snapshot()->tracking);
}

void HandCorrectionTest::AFrameThatFailsWhileTheHandHoldsEndsTheDrag() {
  QTest::mousePress(guidance().picture(), Qt::LeftButton, Qt::ShiftModifier, at(0.0));
  QVERIFY(guidance().correction.line.value().has_value());
  case_->operation->next_frame_fails = true;
  guidance().playback.step();
  QTRY_COMPARE(live().overlay.nodes_in_camera.rows(), 0);
  QTest::qWait(300);
  move(10.0);
  QVERIFY(!guidance().correction.line.value());
  QTest::mouseRelease(guidance().picture(), Qt::LeftButton, Qt::ShiftModifier, at(10.0));
  QCOMPARE(standing(), std::size_t{0});
  guidance().playback.step();
  QTRY_VERIFY(live().overlay.nodes_in_camera.rows() > 0);
  drag(12.0, Qt::ShiftModifier);
  QCOMPARE(standing(), std::size_t{1});
}

void HandCorrectionTest::EscapeLeavesNothing() {
  const double before = place_x();
  QTest::mousePress(guidance().picture(), Qt::LeftButton, Qt::ShiftModifier, at(0.0));
  QTest::qWait(300);
  move(10.0);
  QTRY_COMPARE(standing(), std::size_t{1});
  QTest::keyClick(&guidance().view, Qt::Key_Escape);
  QTRY_COMPARE(standing(), std::size_t{0});
  QVERIFY(std::abs(place_x() - before) < 1e-9);
  QTRY_VERIFY(engine().tasks().empty());
  QVERIFY(guidance().correction.record().empty());
  QTest::mouseRelease(guidance().picture(), Qt::LeftButton, Qt::ShiftModifier, at(10.0));
  QCOMPARE(standing(), std::size_t{0});
}

void HandCorrectionTest::AHandThatHasGivenUpMovesNothing() {
  QTest::mousePress(guidance().picture(), Qt::LeftButton, Qt::ShiftModifier, at(0.0));
  QTest::qWait(300);
  move(10.0);
  QVERIFY(!engine().tasks().empty());  // a piece is on its way
  guidance().correction.give_up();
  move(20.0);  // the button is still down
  QVERIFY(!guidance().correction.line.value());
  QTest::mouseRelease(guidance().picture(), Qt::LeftButton, Qt::ShiftModifier, at(20.0));
  QVERIFY(!guidance().correction.line.value());
  QTRY_VERIFY(engine().tasks().empty());
  QTRY_COMPARE(standing(), std::size_t{0});
  QVERIFY(guidance().correction.record().empty());
}

void HandCorrectionTest::NothingIsCorrectedOfAFormerFrame() {
  QVERIFY(guidance().correction.is_offered);
  QTRY_VERIFY(guidance().review.is_offered);
  guidance().review.seek(guidance().review.first);
  QTRY_VERIFY(!guidance().correction.is_offered);
  QVERIFY(!guidance().correction.grab({150.0, 90.0}));
  guidance().review.go_live();
  QTRY_VERIFY(guidance().correction.is_offered);
}

void HandCorrectionTest::FormerFramesAreNotDrawnByAnotherCalibration() {
  QTRY_VERIFY(guidance().review.is_offered);
  guidance().playback.stop();
  QTRY_VERIFY(!engine().snapshot()->tracking);
  QVERIFY(guidance().review.is_offered);
  case_->operation->rig.left.matrix(0, 0) *= 1.2;
  engine().post(engine::SetCalibration{"scope.yml"});
  QTRY_VERIFY(!guidance().review.is_offered);
}

void HandCorrectionTest::WhatWasSaidAndChosenIsOfItsCase() {
  drag(12.0, Qt::ShiftModifier);
  guidance().live.choose(structure::kFirstLesion);
  QVERIFY(!guidance().correction.said.value().isEmpty());
  const std::filesystem::path other = case_->folder->path() / "other.glisson";
  QVERIFY(engine::save_case(other, {}, RunContext()));
  engine().post(engine::OpenCase{other});
  QTRY_VERIFY(engine().tasks().empty());
  QTRY_VERIFY(!engine().state()[part::model]);
  QCOMPARE(guidance().correction.said.value(), QString());
  QCOMPARE(guidance().live.chosen.value(), Label{0});
}

void HandCorrectionTest::CorrectionsStandBesideTheRecording() {
  const std::filesystem::path film = case_->folder->path() / "live.mkv";
  guidance().recording.start(QString::fromStdString(film.string()));
  drag(12.0, Qt::ShiftModifier);
  guidance().playback.pause(false);
  QTRY_VERIFY(live().frames > 10);
  guidance().playback.stop();
  QTRY_VERIFY(!guidance().recording.is_recording);
  const std::vector<CorrectionLine> lines = read_corrections(film.string() + ".corrections.jsonl");
  QCOMPARE(lines.size(), std::size_t{1});
  QVERIFY(lines.front().correction && lines.front().has_place);
  QVERIFY(std::abs((lines.front().correction->to - lines.front().correction->from).x() - 12.0) < 1.5);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::HandCorrectionTest>(argc, argv); }
#include "hand_correction_test.moc"
