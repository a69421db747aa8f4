// SPDX-License-Identifier: GPL-3.0-or-later
// The right camera's picture: the overlay lies in it where that camera sees the organ, and hands correct
// there.
#include <QCoreApplication>
#include <QMouseEvent>
#include <QTest>
#include <QToolButton>

#include "box_patient.h"
#include "glisson/engine/parts/live.h"
#include "glisson/ui/guidance/overlay_worker.h"
#include "glisson/ui/scene/drawable_model.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "overlay_frames.h"
#include "run_in_window.h"
#include "tracked_case.h"

namespace glisson {
class RightPictureTest : public QObject {
  Q_OBJECT
 private slots:
  void ALesionIsDrawnWhereTheRightCameraProjectsIt();
  void WhatIsNotKnownOfALesionTurnsAlong();
  void ItIsShownBesideTheLeftOneAndGoesAgain();
  void OneOfAnotherSizeLeavesTheLeftOneAlone();
  void AHandDragsInItsPixels();
};

void RightPictureTest::ALesionIsDrawnWhereTheRightCameraProjectsIt() {
  StereoRig rig;
  rig.left = rig.right = laparoscope();
  rig.right.matrix(0, 2) += 12.0;
  const double angle = 0.05;  // the cameras squint
  rig.right_from_left.rotation << std::cos(angle), 0, -std::sin(angle), 0, 1, 0, std::sin(angle), 0,
      std::cos(angle);
  rig.right_from_left.translation = {-0.006, 0.001, 0.0};
  PatientModel model = box_patient();
  const Eigen::Vector3d lesion(0.02, 0.01, 0.0), shift(0.0, 0.0, 0.13);
  model.surfaces.back().mesh = ball_mesh(lesion, 0.003, 16);
  scene::OverlayStyle style;
  style.portal_vein = style.hepatic_veins = style.arteries = style.outline = style.anterior_margin = false;
  style.legend = style.status = false;
  scene::OverlayPainter painter(model, rig.right, style);
  const Picture frame = grey_frame(rig.right);
  const OverlayFrame left = at(model.mesh.vertices.rowwise() + shift.transpose());
  const Eigen::Vector2d seen =
      centre_of_change(frame, painter.paint(frame, scene::seen_from_right(left, rig)));
  const Eigen::Vector3d in_left = lesion + shift;
  // Written out: x to the right, as the rotation above has it.
  const Eigen::Vector3d in_right(std::cos(angle) * in_left.x() - std::sin(angle) * in_left.z() - 0.006,
                                 in_left.y() + 0.001,
                                 std::sin(angle) * in_left.x() + std::cos(angle) * in_left.z());
  const Eigen::Matrix3d& k = rig.right.matrix;
  const Eigen::Vector2d expected(k(0, 0) * in_right.x() / in_right.z() + k(0, 2),
                                 k(1, 1) * in_right.y() / in_right.z() + k(1, 2));
  QVERIFY2((seen - expected).norm() < 1.0, qPrintable(QString::number((seen - expected).norm())));
}

void RightPictureTest::WhatIsNotKnownOfALesionTurnsAlong() {
  StereoRig rig;
  rig.right_from_left.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  rig.right_from_left.translation = {0.5, 0.0, 0.0};
  OverlayFrame left = at(Points::Zero(0, 3));
  left.lesions.front().centre = {1.0, 2.0, 3.0};
  left.lesions.front().covariance = Eigen::Vector3d(4.0, 9.0, 1.0).asDiagonal();
  const LesionVerdict right = scene::seen_from_right(left, rig).lesions.front();
  QCOMPARE(right.centre, Eigen::Vector3d(-1.5, 1.0, 3.0));
  QCOMPARE(right.covariance, Eigen::Matrix3d(Eigen::Vector3d(9.0, 4.0, 1.0).asDiagonal()));
}

void RightPictureTest::ItIsShownBesideTheLeftOneAndGoesAgain() {
  TrackedCase<LivePart> tracked;
  tracked.register_it();
  ui::LiveView& view = tracked.guidance->view;
  auto* right = view.findChild<ui::LivePicture*>(QStringLiteral("right_picture"));
  QVERIFY(!right->isVisible());
  QTest::keyClick(&view, Qt::Key_V);
  QTRY_VERIFY(right->isVisible() && !right->picture().empty());
  QVERIFY(*right->picture().bytes != *tracked.guidance->live.picture().bytes);  // 4.5 mm beside
  tracked.begin_tracking();
  const Picture before = right->picture();
  tracked.guidance->playback.step();
  QTRY_VERIFY(right->picture().bytes != before.bytes);
  auto* button = view.findChild<QToolButton*>(QStringLiteral("show_right"));
  QVERIFY(button->isChecked());
  button->click();
  QTRY_VERIFY(!right->isVisible());
}

void RightPictureTest::OneOfAnotherSizeLeavesTheLeftOneAlone() {
  ui::OverlayWorker worker;
  ui::PaintedOverlay shown;
  int count = 0;
  connect(&worker, &ui::OverlayWorker::painted, this, [&](const ui::PaintedOverlay& painted) {
    shown = painted;
    ++count;
  });
  StereoRig rig;
  rig.left = rig.right = laparoscope();
  ui::OverlayJob job;
  job.model = scene::make_drawable(std::make_shared<const PatientModel>(box_patient()));
  job.rig = std::make_shared<const StereoRig>(rig);
  job.overlay = at(job.model->model->mesh.vertices.rowwise() + Eigen::RowVector3d(0.0, 0.0, 0.13));
  job.frame = job.right = grey_frame(rig.left);
  job.with_right = true;
  worker.submit(job);
  QTRY_COMPARE(count, 1);
  QVERIFY(!shown.right.empty());
  rig.right.width /= 2;
  job.right = grey_frame(rig.right);
  worker.submit(job);
  QTRY_COMPARE(count, 2);
  QVERIFY(shown.right.empty() && !shown.picture.empty());
}

void RightPictureTest::AHandDragsInItsPixels() {
  TrackedCase<LivePart> tracked;
  tracked.register_it();
  tracked.begin_tracking();
  LivePart& guidance = *tracked.guidance;
  QTest::keyClick(&guidance.view, Qt::Key_V);
  auto* right = guidance.view.findChild<ui::LivePicture*>(QStringLiteral("right_picture"));
  QTRY_VERIFY(right->isVisible() && !right->picture().empty());
  const auto at_pixel = [right](double x) { return right->widget_point({x, 90.0}).toPoint(); };
  QTest::mousePress(right, Qt::LeftButton, Qt::ShiftModifier, at_pixel(150.0));
  QVERIFY(guidance.correction.line.value() && guidance.correction.line.value()->view == StereoView::right);
  QMouseEvent move(QEvent::MouseMove, at_pixel(156.0), right->mapToGlobal(at_pixel(156.0)), Qt::NoButton,
                   Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(right, &move);
  QTest::mouseRelease(right, Qt::LeftButton, Qt::ShiftModifier, at_pixel(162.0));
  ui::EngineBridge& engine = *tracked.engine;
  QTRY_VERIFY(engine.tasks().empty() && !guidance.correction.line.value());
  const engine::LiveState& live = *engine.state()[part::live];
  QCOMPARE(live.corrections.size(), std::size_t{1});
  const Correction& made = live.corrections.front().correction;
  QCOMPARE(made.view, StereoView::right);
  // What was taken hold of is drawn there now, as the right camera sees it.
  const TetMesh& mesh = tracked.operation->model.mesh;
  const StereoRig& rig = tracked.operation->rig;
  const Eigen::Vector3d place = bind_points(mesh, made.place_in_ct.transpose())
                                    .apply(mesh, live.overlay.nodes_in_camera)
                                    .row(0)
                                    .transpose();
  const double drawn = rig.right.project(place + rig.right_from_left.translation).x();
  QVERIFY2(std::abs(drawn - 162.0) < 2.5, qPrintable(QString::number(drawn)));
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::RightPictureTest>(argc, argv); }
#include "right_picture_test.moc"
