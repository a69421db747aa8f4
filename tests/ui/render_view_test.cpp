// SPDX-License-Identifier: GPL-3.0-or-later
// What VTK has drawn is what the view shows, and it draws when the scene has changed, not at every repaint.
#include "glisson/ui/common/render_view.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QApplication>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

namespace glisson {
namespace {

/// The lower half of what the camera sees, in green and without shades.
void add_floor(vtkRenderer& renderer) {
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-10, -10, 0);
  plane->SetPoint1(10, -10, 0);
  plane->SetPoint2(-10, 0, 0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0, 1, 0);
  actor->GetProperty()->LightingOff();
  renderer.AddActor(actor);
  renderer.SetBackground(1, 0, 0);
  renderer.GradientBackgroundOff();
  renderer.GetActiveCamera()->SetPosition(0, 0, 3);
  renderer.GetActiveCamera()->SetFocalPoint(0, 0, 0);
  renderer.GetActiveCamera()->SetViewUp(0, 1, 0);
}

}  // namespace

class RenderViewTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatIsDrawnIsShownTheRightWayUp();
  void ItIsDrawnAnewWhenTheSceneHasChanged();
  void TheSceneStaysInAViewOfAnotherSizeUntilSomebodyMovesIt();
};

void RenderViewTest::WhatIsDrawnIsShownTheRightWayUp() {
  ui::RenderView view;
  add_floor(view.patient().renderer());
  view.resize(300, 200);
  view.show();
  QVERIFY(QTest::qWaitForWindowExposed(&view));
  QTRY_VERIFY(!view.picture().isNull());
  QTRY_COMPARE(view.picture().size(), view.size() * view.devicePixelRatio());
  const QImage shown = view.grab().toImage();
  QCOMPARE(shown.pixelColor(shown.width() / 2, shown.height() / 8), QColor(Qt::red));
  QCOMPARE(shown.pixelColor(shown.width() / 2, 7 * shown.height() / 8), QColor(Qt::green));
}

/// Nobody has turned it: what is 20 wide is as wide a part of a narrow view as of one that was narrow before.
void RenderViewTest::TheSceneStaysInAViewOfAnotherSizeUntilSomebodyMovesIt() {
  ui::RenderView view;
  scene::PatientScene& patient = view.patient();
  add_floor(patient.renderer());
  view.resize(400, 200);
  view.show();
  QVERIFY(QTest::qWaitForWindowExposed(&view));
  QTRY_COMPARE(view.picture().size(), view.size() * view.devicePixelRatio());
  patient.look_from(scene::ViewFrom::superior);  // along -z, as the floor faces
  const auto wide = [&] {
    const auto left = patient.view_point({-10, -5, 0}, view.aspect()),
               right = patient.view_point({10, -5, 0}, view.aspect());
    return left && right ? std::abs(right->x() - left->x()) : -1.0;
  };
  const auto resized = [&](int w, int h) {
    view.resize(w, h);
    QTRY_COMPARE(view.picture().size(), view.size() * view.devicePixelRatio());
  };
  resized(120, 400);
  const double narrow = wide();
  QVERIFY2(narrow > 0.5 && narrow < 1.2, qPrintable(QString::number(narrow)));
  resized(400, 200);
  resized(120, 400);
  QVERIFY(std::abs(wide() - narrow) < 1e-9);
  patient.renderer().GetActiveCamera()->Roll(20.0);  // somebody turns it
  resized(300, 200);
  QVERIFY(std::abs(patient.renderer().GetActiveCamera()->GetRoll()) > 10.0);
  patient.renderer().GetActiveCamera()->Dolly(2.0);  // and looks closer
  const Eigen::Vector3d moved(patient.renderer().GetActiveCamera()->GetPosition());
  resized(400, 200);
  QVERIFY((Eigen::Vector3d(patient.renderer().GetActiveCamera()->GetPosition()) - moved).norm() < 1e-12);
}

void RenderViewTest::ItIsDrawnAnewWhenTheSceneHasChanged() {
  ui::RenderView view;
  add_floor(view.patient().renderer());
  view.resize(300, 200);
  view.show();
  QVERIFY(QTest::qWaitForWindowExposed(&view));
  QTRY_VERIFY(!view.picture().isNull());
  QSignalSpy drawn(&view, &ui::RenderView::drawn);
  // A label over it changes, the window is uncovered: nothing of the scene.
  view.set_title(QStringLiteral("3D"));
  view.repaint();
  view.repaint(10, 10, 50, 50);
  QCOMPARE(drawn.size(), 0);
  view.patient().renderer().SetBackground(0, 0, 1);
  view.update();
  view.update();
  QTRY_COMPARE(drawn.size(), 1);
  QCOMPARE(view.grab().toImage().pixelColor(150, 20), QColor(Qt::blue));
  view.resize(320, 240);
  QTRY_COMPARE(view.picture().size(), view.size() * view.devicePixelRatio());
  // Hidden, it costs nothing; shown again, it is of the scene as it is then.
  view.hide();
  const auto before = drawn.size();
  view.patient().renderer().SetBackground(1, 1, 0);
  view.update();
  QTest::qWait(50);
  QCOMPARE(drawn.size(), before);
  view.show();
  QTRY_COMPARE(view.picture().pixelColor(160, 20), QColor(Qt::yellow));
}

}  // namespace glisson

int main(int argc, char** argv) {
  glisson::ui::RenderView::prepare_surface_format();
  QApplication application(argc, argv);
  glisson::RenderViewTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "render_view_test.moc"
