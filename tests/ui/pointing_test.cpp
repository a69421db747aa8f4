// SPDX-License-Identifier: GPL-3.0-or-later
// What a hand points at in the views: places, seeds, landmarks, regions.
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QApplication>
#include <QCoreApplication>
#include <QListWidget>
#include <QMouseEvent>
#include <QPushButton>
#include <QTest>
#include <QWheelEvent>

#include "fake_operation.h"
#include "glisson/engine/commands/set_landmarks.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/regions.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/ui/atlas/atlas_panel.h"
#include "glisson/ui/scene/colours.h"
#include "glisson/ui/segmentation/segmentation_panel.h"
#include "glisson/ui/shell/main_window.h"
#include "glisson/ui/stereo/stereo_panel.h"
#include "operated_window.h"

namespace glisson {

using engine::StageState;
using ui::MainWindow;

class PointingTest : public QObject, private OperatedWindow {
  Q_OBJECT
 private slots:
  void init() { open_window(); }
  void cleanup() { close_window(); }
  void ClickMovesTheCrosshairInAllSlices();
  void ProbeLineSaysWhatIsUnderThePointer();
  void WheelStepsBySlices();
  void RightDragChangesTheWindow();
  void SeedsAreClickedListedAndDeleted();
  void NotchIsPlacedOnTheSurface();
  void TheFirstClickAfterClearReplacesTheModelsOwn();
  void NothingIsPlacedOnAModelThatIsBeingMade();
  void LandmarksAreDrawnWithTheModelOnly();
  void RegionIsClickedClosedDraggedAndTakenBack();
};

void PointingTest::ClickMovesTheCrosshairInAllSlices() {
  open_ct();
  const Point<CtFrame> target(0.03, -0.012, 0.0);
  click(slice(scene::Plane::axial), target);
  QVERIFY(std::abs(slice(scene::Plane::sagittal).geometry_in_ct().origin.x() - 0.03) < 1e-3);
  QVERIFY(std::abs(slice(scene::Plane::coronal).geometry_in_ct().origin.y() + 0.012) < 1e-3);
}

void PointingTest::ProbeLineSaysWhatIsUnderThePointer() {
  reach_model();
  ui::SliceView& axial = slice(scene::Plane::axial);
  const Point<CtFrame> lesion(0.03, 0.0, axial.geometry_in_ct().origin.z());
  QTest::mouseMove(&axial, axial.widget_point(lesion).toPoint());
  QTRY_VERIFY(window_->views().probe_line().contains(QStringLiteral("60 HU")));
  QVERIFY(window_->views().probe_line().contains(QStringLiteral("L 30")) ||
          window_->views().probe_line().contains(QStringLiteral("L 29")));
  QVERIFY(window_->views().probe_line().contains(QStringLiteral("Lesion 1")));
  const Point<CtFrame> liver(-0.04, 0.0, axial.geometry_in_ct().origin.z());
  QTest::mouseMove(&axial, axial.widget_point(liver).toPoint());
  QTRY_VERIFY(window_->views().probe_line().contains(QStringLiteral("110 HU")));
  QVERIFY(window_->views().probe_line().startsWith(QLatin1Char('R')));
  QVERIFY(window_->views().probe_line().contains(QStringLiteral("Liver")));
}

void PointingTest::WheelStepsBySlices() {
  open_ct();
  ui::SliceView& axial = slice(scene::Plane::axial);
  const double before = axial.geometry_in_ct().origin.z();
  QWheelEvent wheel(QPointF(100, 100), axial.mapToGlobal(QPointF(100, 100)), {}, QPoint(0, 240), Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&axial, &wheel);
  QVERIFY(std::abs(axial.geometry_in_ct().origin.z() - before - 0.004) < 1e-9);  // two slices of 2 mm
}

void PointingTest::RightDragChangesTheWindow() {
  open_ct();
  ui::SliceView& axial = slice(scene::Plane::axial);
  const Picture before = axial.slice();
  QTest::mousePress(&axial, Qt::RightButton, {}, QPoint(100, 100));
  QMouseEvent move(QEvent::MouseMove, QPointF(160, 80), axial.mapToGlobal(QPointF(160, 80)), Qt::NoButton,
                   Qt::RightButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&axial, &move);
  QTest::mouseRelease(&axial, Qt::RightButton, {}, QPoint(160, 80));
  QVERIFY(*before.bytes != *axial.slice().bytes);
}

void PointingTest::SeedsAreClickedListedAndDeleted() {
  open_ct();
  auto* panel = window_->findChild<ui::SegmentationPanel*>();
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("seed_parenchyma")), Qt::LeftButton);
  const double z = slice(scene::Plane::axial).geometry_in_ct().origin.z();
  click(slice(scene::Plane::axial), Point<CtFrame>(-0.03, 0.01, z));
  click(slice(scene::Plane::axial), Point<CtFrame>(0.02, 0.01, z));
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("seed_lesion_1")), Qt::LeftButton);
  click(slice(scene::Plane::axial), Point<CtFrame>(0.03, 0.0, z));
  QVERIFY(settle());
  const auto& stored = window_->engine().state()[part::seeds];
  QVERIFY(stored != nullptr);
  QCOMPARE(stored->liver.rows(), 2);
  QVERIFY(std::abs(stored->liver(0, 0) + 0.03) < 1e-3 && std::abs(stored->liver(0, 1) - 0.01) < 1e-3);
  QCOMPARE(stored->lesions.size(), std::size_t{1});
  auto* list = panel->findChild<QListWidget*>(QStringLiteral("seed_list"));
  QCOMPARE(list->count(), 3);
  list->setCurrentRow(0);
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("delete_seeds")), Qt::LeftButton);
  QVERIFY(settle());
  QCOMPARE(window_->engine().state()[part::seeds]->liver.rows(), 1);
  QVERIFY(std::abs(window_->engine().state()[part::seeds]->liver(0, 0) - 0.02) < 1e-3);
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("seed_lesion_1")),
                    Qt::LeftButton);                               // ends placing
  click(slice(scene::Plane::axial), Point<CtFrame>(0.0, 0.0, z));  // only the crosshair now
  QVERIFY(settle());
  QCOMPARE(window_->engine().state()[part::seeds]->liver.rows(), 1);
}

void PointingTest::NotchIsPlacedOnTheSurface() {
  reach_model();
  window_->show_step(MainWindow::atlas);
  ui::RenderView& view = window_->views().volume();
  // The model is made drawable beside the window.
  QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
  auto* panel = window_->findChild<ui::AtlasPanel*>();
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("place_notch")), Qt::LeftButton);
  const auto before = panel->landmarks().umbilical_notch.rows();
  const Eigen::Vector3d wanted(0.02, -0.04, 0.005);  // on the anterior face
  const auto place = view.patient().view_point(wanted, view.aspect());
  QVERIFY(place.has_value());
  QTest::mouseClick(
      &view, Qt::LeftButton, {},
      QPoint(static_cast<int>(place->x() * view.width()), static_cast<int>(place->y() * view.height())));
  QVERIFY(settle());
  const auto& stored = window_->engine().state()[part::landmarks];
  QVERIFY(stored != nullptr);
  QCOMPARE(stored->umbilical_notch.rows(), before + 1);
  QVERIFY((stored->umbilical_notch.bottomRows(1).transpose() - wanted).norm() < 2e-3);  // a pixel or so
}

void PointingTest::TheFirstClickAfterClearReplacesTheModelsOwn() {
  operation_->model.landmarks.umbilical_notch = Points::Constant(3, 3, 0.02);
  reach_model();
  window_->show_step(MainWindow::atlas);
  QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
  auto* panel = window_->findChild<ui::AtlasPanel*>();
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("clear_landmarks")), Qt::LeftButton);
  QVERIFY(settle());
  QTRY_COMPARE(panel->landmarks().umbilical_notch.rows(), 3);  // what the registration would use
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("place_notch")), Qt::LeftButton);
  ui::RenderView& view = window_->views().volume();
  for (const int points : {1, 2}) {
    QTest::mouseClick(&view, Qt::LeftButton, {}, view.rect().center());
    QVERIFY(settle());
    QTRY_COMPARE(window_->engine().state()[part::landmarks]->umbilical_notch.rows(), points);
  }
}

void PointingTest::NothingIsPlacedOnAModelThatIsBeingMade() {
  reach_model();
  window_->show_step(MainWindow::atlas);
  QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
  auto* panel = window_->findChild<ui::AtlasPanel*>();
  auto* accept = panel->findChild<QPushButton*>(QStringLiteral("accept_landmarks"));
  auto* place = panel->findChild<QPushButton*>(QStringLiteral("place_notch"));
  QTest::mouseClick(place, Qt::LeftButton);
  operation_->hold = true;
  window_->engine().post(engine::BuildModel{});
  QVERIFY(!accept->isEnabled() && !place->isEnabled());
  // It would be stored once the new model is there, as if it had been placed on that.
  QTest::mouseClick(&window_->views().volume(), Qt::LeftButton, {},
                    window_->views().volume().rect().center());
  operation_->hold = false;
  QVERIFY(settle());
  QVERIFY(window_->engine().state()[part::landmarks] == nullptr);
  QVERIFY(accept->isEnabled() && place->isEnabled());
}

void PointingTest::LandmarksAreDrawnWithTheModelOnly() {
  reach_model();
  Landmarks placed;
  placed.umbilical_notch.resize(1, 3);
  placed.umbilical_notch << 0.02, -0.04, 0.005;
  ui::LinkedViews& views = window_->views();
  const QColor colour = scene::colour_of(Feature::umbilical_notch);
  const auto is_drawn = [&] {
    vtkActorCollection& actors = *views.volume().patient().renderer().GetActors();
    vtkCollectionSimpleIterator at;
    actors.InitTraversal(at);
    while (vtkActor* actor = actors.GetNextActor(at)) {
      const double* rgb = actor->GetProperty()->GetColor();
      if (QColor::fromRgbF(rgb[0], rgb[1], rgb[2]).rgb() == colour.rgb()) return true;
    }
    return false;
  };
  window_->show_step(MainWindow::atlas);
  window_->engine().post(engine::SetLandmarks{placed});
  QTRY_VERIFY(is_drawn());
  window_->show_step(MainWindow::segmentation);  // there the labels stand in for the model
  QTRY_VERIFY(!is_drawn());
  placed.umbilical_notch(0, 0) = 0.01;
  window_->engine().post(engine::SetLandmarks{placed});
  QVERIFY(settle());
  QTRY_VERIFY(views.label_surfaces().surfaces() != nullptr);
  QVERIFY(!is_drawn());
  window_->show_step(MainWindow::atlas);
  QTRY_VERIFY(is_drawn());
}

void PointingTest::RegionIsClickedClosedDraggedAndTakenBack() {
  reach_registration();
  window_->show_step(MainWindow::stereo);
  auto* panel = window_->findChild<ui::StereoPanel*>();
  ui::RegionEditor& editor = panel->stereo_view().editor(stereo::Side::left);
  QTRY_VERIFY(editor.isVisible() && !editor.picture().empty());
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("region_2")), Qt::LeftButton);
  const auto at = [&](double x, double y) { return editor.widget_point({x, y}).toPoint(); };
  QTest::mouseClick(&editor, Qt::LeftButton, {}, at(100, 50));
  QTest::mouseClick(&editor, Qt::LeftButton, {}, at(200, 60));
  QTest::mouseClick(&editor, Qt::LeftButton, {}, at(300, 170));
  QTest::keyClick(&editor, Qt::Key_Backspace);
  // A look at another step does not cost what was drawn so far.
  window_->show_step(MainWindow::atlas);
  window_->show_step(MainWindow::stereo);
  QVERIFY(panel->stereo_view().drawing().unfinished() != nullptr);
  QCOMPARE(panel->stereo_view().drawing().unfinished()->polygon.size(), std::size_t{2});
  QTest::mouseClick(&editor, Qt::LeftButton, {}, at(180, 120));
  QTest::mouseClick(&editor, Qt::LeftButton, {}, at(100, 50));
  QVERIFY(settle());
  const auto& regions = window_->engine().state()[part::regions];
  QVERIFY(regions != nullptr);
  QCOMPARE(regions->regions.size(), std::size_t{1});
  QCOMPARE(regions->regions[0].feature, Feature::anterior_margin);
  QCOMPARE(regions->regions[0].polygon.size(), std::size_t{3});
  QVERIFY((regions->regions[0].polygon[1] - Eigen::Vector2d(200, 60)).norm() < 1.0);
  QCOMPARE(stage(part::cloud), StageState::stale);  // the cloud was made without it
  QTest::keyClick(&editor, Qt::Key_Escape);
  QTest::mousePress(&editor, Qt::LeftButton, {}, at(200, 60));
  QMouseEvent move(QEvent::MouseMove, QPointF(at(230, 70)), editor.mapToGlobal(QPointF(at(230, 70))),
                   Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&editor, &move);
  QTest::mouseRelease(&editor, Qt::LeftButton, {}, at(230, 70));
  QVERIFY(settle());
  QVERIFY(
      (window_->engine().state()[part::regions]->regions[0].polygon[1] - Eigen::Vector2d(230, 70)).norm() <
      1.0);
  QTest::mouseClick(&editor, Qt::RightButton, {}, at(170, 75));
  QVERIFY(settle());
  QVERIFY(window_->engine().state()[part::regions]->regions.empty());
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::PointingTest>(argc, argv); }
#include "pointing_test.moc"
