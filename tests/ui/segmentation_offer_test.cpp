// SPDX-License-Identifier: GPL-3.0-or-later
// Segment over labels that a hand has corrected: what would change is seen, and the person decides.
#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QKeySequence>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>

#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/hand_edits.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/ui/scene/difference_overlay.h"
#include "glisson/ui/segmentation/segmentation_panel.h"
#include "segmentation_window.h"

namespace glisson {

using scene::Plane;

class SegmentationOfferTest : public QObject, private SegmentationWindow {
  Q_OBJECT
 private slots:
  void initTestCase() { make_ct(); }
  void init() { show_window(); }
  void cleanup() { window_.reset(); }
  void WhatWouldChangeIsSeenBeforeAnythingDoes();
  void EachChoiceDoesWhatItSaysAndUndoTakesItBack();
  void NothingElseIsAtHandWhileTheDecisionWaits();
  void ClosingSaysThatTheNewOneGoes();
  void AnotherCaseIsNotOpenedWithoutSayingThatTheNewOneGoes();
  void DroppedLabelsAskFirst();
  void UndoWaitsForTheDecision();
  void ToolsAndImportWaitForTheDecision();
  void WhatIsDoneWhileItIsGrownDoesNotMeetIt();
  void SavingWhileItIsGrownKeepsTheCorrections();
  void CorrectionsOnAnotherCtAreReplacedWhenAPersonSaysSo();
  void AClickOnADrawnLesionWaitsForTheDecision();

 private:
  /// A hand adds to the liver above it, and the liver is grown over that.
  void correct_and_grow();
  bool waits() { return window_->engine().state()[part::offer] != nullptr; }
  /// Answers the next question. @return what it said
  QString answer(QMessageBox::StandardButton with, const std::function<void()>& ask);
};

void SegmentationOfferTest::correct_and_grow() {
  correct_by_hand();
  seed_liver();
  find<QDoubleSpinBox>("segment_resolution")->setValue(4.0);  // soon there
  grow();
  QVERIFY(waits());
}

QString SegmentationOfferTest::answer(QMessageBox::StandardButton with, const std::function<void()>& ask) {
  QString told;
  QTimer poll;
  connect(&poll, &QTimer::timeout, this, [&] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (question == nullptr) return;
    told = question->text();
    QTest::mouseClick(question->button(with), Qt::LeftButton);
  });
  poll.start(20);
  ask();
  return told;
}

void SegmentationOfferTest::WhatWouldChangeIsSeenBeforeAnythingDoes() {
  correct_and_grow();
  const auto offer = window_->engine().state()[part::offer];
  QVERIFY(find<QWidget>("offer_box")->isVisible());
  QCOMPARE(at({0.0, -0.050, 0.0}), structure::kParenchyma);
  QVERIFY(offer->difference.hand_changed > 50);
  const QString said = find<QLabel>("offer_hand")->text();
  QVERIFY2(said.contains(QLocale().toString(static_cast<qlonglong>(offer->difference.hand_changed))),
           qPrintable(said));
  // The slices went there, and what the hand added is marked as going.
  QVERIFY(window_->views().state().offer() == offer);
  const Eigen::Vector3i most = *offer->difference.where_most;
  const auto& grid = labels().grid();
  QVERIFY((window_->views().state().crosshair().xyz - grid.p_in_ct(most.cast<double>()).xyz).norm() < 1e-9);
  const QImage drawn = scene::difference_overlay(labels(), offer->labels.voxels, offer->hand,
                                                 slice(Plane::axial).geometry_in_ct());
  const auto pixel = slice(Plane::axial).geometry_in_ct().pixel_of(Point<CtFrame>(0.0, -0.052, 0.0));
  const QColor colour = drawn.pixelColor(qRound(pixel.x()), qRound(pixel.y()));
  QVERIFY2(colour.red() > colour.blue(), qPrintable(colour.name()));  // orange
  // Another step of the work does not show it.
  panel().deactivate();
  QVERIFY(!window_->views().state().offer());
  panel().activate();
  QVERIFY(window_->views().state().offer() == offer);
}

void SegmentationOfferTest::EachChoiceDoesWhatItSaysAndUndoTakesItBack() {
  correct_and_grow();
  const LabelVolume mine = labels();
  const auto offer = window_->engine().state()[part::offer];
  press("offer_keep_all");
  QVERIFY(settle());
  QVERIFY(!waits() && labels() == mine);
  QVERIFY(!find<QWidget>("offer_box")->isVisible() && find<QWidget>("segment")->isVisible());
  grow();
  QVERIFY(waits());
  press("offer_keep_hand");
  QVERIFY(settle());
  QVERIFY(labels() == keeping_hand(mine, offer->labels.voxels, offer->hand));
  QVERIFY(!(labels() == mine));
  const auto undo = [&] {
    panel().history_actions().front()->trigger();
    return settle();
  };
  QVERIFY(undo() && labels() == mine);
  grow();
  press("offer_take");
  QVERIFY(settle());
  QVERIFY(labels() == offer->labels.voxels);
  grow();
  QVERIFY(!waits());  // a machine's work alone
  QVERIFY(undo() && labels() == mine);
}

void SegmentationOfferTest::NothingElseIsAtHandWhileTheDecisionWaits() {
  open_ct();
  press("mode_seeds");
  QVERIFY(!find<QWidget>("offer_box")->isVisible());
  correct_and_grow();
  QVERIFY(!find<QWidget>("segment")->isVisible() && !find<QPushButton>("mode_edit")->isEnabled());
  QCOMPARE(window_->views().state().hand(), ui::Hand::crosshair);
  press("offer_keep_all");
  QVERIFY(settle());
  QVERIFY(find<QWidget>("segment")->isVisible() && find<QPushButton>("mode_edit")->isEnabled());
}

void SegmentationOfferTest::ClosingSaysThatTheNewOneGoes() {
  correct_and_grow();
  const LabelVolume mine = labels();
  const QString told = answer(QMessageBox::Cancel, [&] { window_->close(); });
  QVERIFY2(told.contains("not saved") && told.contains("new segmentation"), qPrintable(told));
  QVERIFY(window_->isVisible() && waits() && labels() == mine);
}

void SegmentationOfferTest::AnotherCaseIsNotOpenedWithoutSayingThatTheNewOneGoes() {
  correct_and_grow();
  const TemporaryFolder folder;
  window_->engine().post(engine::SaveCase{folder.path() / "other.glisson"});
  QVERIFY(settle() && !window_->isWindowModified());
  QVERIFY(waits());
  const LabelVolume mine = labels();
  const QString told = answer(QMessageBox::Cancel, [&] {
    window_->open(folder.path() / "other.glisson");
    QTRY_VERIFY(QApplication::activeModalWidget() == nullptr);
  });
  QVERIFY2(told.contains("new segmentation"), qPrintable(told));
  QVERIFY(settle() && waits() && labels() == mine);
}

void SegmentationOfferTest::DroppedLabelsAskFirst() {
  correct_and_grow();
  const LabelVolume mine = labels();
  const auto drop = [&] {
    window_->open(folder_->path() / "labels.seg.nrrd");
    QTRY_VERIFY(QApplication::activeModalWidget() == nullptr);
  };
  const QString told = answer(QMessageBox::Cancel, drop);
  QVERIFY2(told.contains("new segmentation"), qPrintable(told));
  QVERIFY(settle() && waits() && labels() == mine);
  answer(QMessageBox::Discard, drop);
  const auto over_hand_work = [this] {
    return window_->findChild<QPushButton*>(QStringLiteral("replace_hand_work"));
  };
  QTRY_VERIFY_WITH_TIMEOUT(over_hand_work() != nullptr && over_hand_work()->isVisible(), 20000);
  QTest::mouseClick(over_hand_work(), Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(!waits() && labels() != mine, 20000);  // the file is looked into first
  QVERIFY(settle());
}

void SegmentationOfferTest::UndoWaitsForTheDecision() {
  correct_and_grow();
  auto* panel = window_->findChild<ui::SegmentationPanel*>();
  for (const QAction* action : panel->history_actions()) QVERIFY(!action->isEnabled());
  press("offer_keep_all");
  QVERIFY(settle());
  QVERIFY(panel->history_actions().front()->isEnabled());  // in the same mode: it was the offer alone
}

void SegmentationOfferTest::ToolsAndImportWaitForTheDecision() {
  correct_and_grow();
  const auto* import = find<QPushButton>("import_labels");
  const LabelVolume mine = labels();
  QTest::keyClick(window_.get(), Qt::Key_P);
  QVERIFY(session().tool() == nullptr);
  QCOMPARE(window_->views().state().hand(), ui::Hand::crosshair);
  drag(slice(Plane::axial), {{-0.02, 0.0, 0.0}, {0.02, 0.0, 0.0}});
  QVERIFY(settle() && waits() && labels() == mine);
  QVERIFY(!import->isEnabled());
  QVERIFY2(import->toolTip().contains("waits"), qPrintable(import->toolTip()));
  press("offer_keep_all");
  QVERIFY(settle());
  QVERIFY(import->isEnabled());
  QVERIFY2(import->toolTip().contains("elsewhere"), qPrintable(import->toolTip()));
  QTest::keyClick(window_.get(), Qt::Key_P);
  QVERIFY(session().tool() != nullptr);
}

void SegmentationOfferTest::WhatIsDoneWhileItIsGrownDoesNotMeetIt() {
  correct_by_hand();
  seed_liver();
  const LabelVolume mine = labels();
  QTest::keyClick(window_.get(), Qt::Key_P);
  press_segment();
  QVERIFY(!window_->engine().tasks().empty());
  // An undo would take the new one back, a stroke or a correcting click would let it go unseen.
  for (const QAction* action : panel().history_actions()) QVERIFY(!action->isEnabled());
  session().undo();
  drag(slice(Plane::axial), {{-0.02, 0.0, 0.0}, {0.02, 0.0, 0.0}});
  press("seed_background");
  QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {},
                    slice(Plane::axial).widget_point(Point<CtFrame>(-0.02, 0.025, 0.0)).toPoint());
  QVERIFY2(find<QLabel>("correction")->text().contains("on their way"),
           qPrintable(find<QLabel>("correction")->text()));
  QCOMPARE(window_->engine().tasks().size(), std::size_t{2});  // it is grown, and the seed is kept
  QVERIFY(settle());
  QVERIFY(waits() && labels() == mine);
  QCOMPARE(window_->engine().state()[part::seeds]->background.rows(), Eigen::Index{1});
}

void SegmentationOfferTest::SavingWhileItIsGrownKeepsTheCorrections() {
  correct_by_hand();
  seed_liver();
  const LabelVolume mine = labels();
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "patient.glisson";
  window_->engine().post(engine::SaveCase{path});
  QVERIFY(settle());
  QSignalSpy ended(&window_->engine(), &ui::EngineBridge::finished);
  press_segment();
  for (QAction* action : window_->findChildren<QAction*>())
    if (action->shortcut() == QKeySequence(QKeySequence::Save)) action->trigger();
  auto* question = window_->findChild<QMessageBox*>(QStringLiteral("running_work"));
  QVERIFY(question != nullptr);
  QVERIFY2(question->informativeText().contains("by hand waits for your decision"),
           qPrintable(question->informativeText()));
  QTest::mouseClick(question->findChild<QPushButton*>(QStringLiteral("wait_for_work")), Qt::LeftButton);
  QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 2, 60000);  // grown and saved
  QVERIFY(settle());
  QVERIFY(waits() && labels() == mine);
  const auto saved = engine::open_case(path, RunContext());
  QVERIFY(saved && (*saved)[part::labels]->voxels == mine);
}

void SegmentationOfferTest::CorrectionsOnAnotherCtAreReplacedWhenAPersonSaysSo() {
  correct_by_hand();
  seed_liver();
  find<QDoubleSpinBox>("segment_resolution")->setValue(4.0);
  const LabelVolume mine = labels();
  Image other = ct_;  // the same patient, half a voxel aside
  other.grid.origin_mm += Eigen::Vector3d(1.0, 1.0, 1.0);
  write_image(folder_->path() / "other.nrrd", other);
  window_->engine().post(engine::ImportImage{folder_->path() / "other.nrrd"});
  QVERIFY(settle());
  const auto segment = [&](const char* answer) {
    press_segment();
    QVERIFY(window_->engine().tasks().empty());
    auto* asked = window_->findChild<QMessageBox*>(QStringLiteral("hand_work_question"));
    QVERIFY(asked != nullptr && asked->isVisible());
    QTest::mouseClick(asked->findChild<QPushButton*>(QLatin1String(answer)), Qt::LeftButton);
    QVERIFY(settle());
    QTRY_VERIFY(window_->findChild<QMessageBox*>(QStringLiteral("hand_work_question")) == nullptr);
  };
  segment("keep_hand_work");
  QVERIFY(labels() == mine);
  segment("replace_hand_work");
  QVERIFY(!waits() && labels().grid().same_as(other.grid));
  QVERIFY(count(structure::kParenchyma) > 1000);
}

void SegmentationOfferTest::AClickOnADrawnLesionWaitsForTheDecision() {
  open_labels();
  editing::Paint paint;
  paint.label = structure::kFirstLesion;
  paint.brush = editing::Paint::Brush::ball;
  paint.radius = 6e-3;
  paint.path = Eigen::RowVector3d(-0.03, 0.01, 0.0);
  window_->engine().post(engine::EditLabels{{paint, {}}, 0});
  QVERIFY(settle());
  const LabelVolume mine = labels();
  press("mode_seeds");
  panel().choose_structure(structure::kFirstLesion);  // its button comes with its first seed
  QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {},
                    slice(Plane::axial).widget_point(Point<CtFrame>(0.03, 0.0, 0.0)).toPoint());
  QVERIFY(settle());
  QVERIFY(waits() && labels() == mine);
  QVERIFY2(find<QLabel>("correction")->text().contains("waits for your decision"),
           qPrintable(find<QLabel>("correction")->text()));
  press("offer_take");
  QVERIFY(settle());
  QCOMPARE(at({-0.03, 0.01, 0.0}), structure::kParenchyma);
  QCOMPARE(at({0.03, 0.0, 0.0}), structure::kFirstLesion);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::SegmentationOfferTest>(argc, argv); }
#include "segmentation_offer_test.moc"
