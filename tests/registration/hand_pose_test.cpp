// SPDX-License-Identifier: GPL-3.0-or-later
// A pose that a hand sets: what the mouse does to it, seen through the camera.
#include <QTest>

#include "glisson/core/error.h"
#include "glisson/registration/hand_pose.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

namespace {

const Eigen::Vector3d kMiddle(0.012, -0.04, 0.03);

Camera camera() {
  Camera camera;
  camera.width = 640;
  camera.height = 480;
  camera.matrix << 700, 0, 322, 0, 690, 238, 0, 0, 1;
  camera.distortion << -0.12, 0.03, 1e-3, -5e-4, 0.0;
  return camera;
}

Eigen::Vector3d placed(const CameraFromCt& pose, const Eigen::Vector3d& p) {
  return pose.rotation * p + pose.translation;
}

}  // namespace

class HandPoseTest : public QObject {
  Q_OBJECT
 private slots:
  void UprightHasThePatientsLeftOnTheRightAndTheFeetBelow();
  void TheOrganGoesAlongWithTheMouse();
  void WhatIsBehindTheCameraStays();
  void TurningKeepsTheMiddle();
  void NearerStaysOnItsRay();
};

void HandPoseTest::UprightHasThePatientsLeftOnTheRightAndTheFeetBelow() {
  const Eigen::Vector3d where(0.01, 0.02, 0.14);
  const CameraFromCt pose = upright_before(kMiddle, where);
  QVERIFY((placed(pose, kMiddle) - where).norm() < 1e-12);
  QVERIFY(std::abs(pose.rotation.determinant() - 1.0) < 1e-12);
  // LPS: x to the left, y to the back, z to the head.
  QVERIFY(placed(pose, kMiddle + Eigen::Vector3d(0.05, 0, 0)).x() > where.x() + 0.04);
  QVERIFY(placed(pose, kMiddle - Eigen::Vector3d(0, 0, 0.05)).y() > where.y() + 0.04);
  QVERIFY(placed(pose, kMiddle + Eigen::Vector3d(0, 0.05, 0)).z() > where.z() + 0.04);
}

void HandPoseTest::TheOrganGoesAlongWithTheMouse() {
  const CameraFromCt pose = upright_before(kMiddle, {0.01, 0.02, 0.14});
  const Eigen::Vector2d from = camera().project(placed(pose, kMiddle)), to(151.0, 402.0);
  const CameraFromCt moved = dragged(pose, kMiddle, camera(), from, to);
  QVERIFY((camera().project(placed(moved, kMiddle)) - to).norm() < 1e-4);
  QVERIFY(std::abs(placed(moved, kMiddle).z() - 0.14) < 1e-12);
  QVERIFY(moved.rotation == pose.rotation);
}

void HandPoseTest::WhatIsBehindTheCameraStays() {
  const CameraFromCt pose = upright_before(kMiddle, {0.0, 0.0, -0.1});
  QVERIFY(dragged(pose, kMiddle, camera(), {0, 0}, {100, 100}).translation == pose.translation);
}

void HandPoseTest::TurningKeepsTheMiddle() {
  const CameraFromCt pose = upright_before(kMiddle, {0.01, 0.02, 0.14});
  const CameraFromCt quarter = turned(pose, kMiddle, {0.0, 0.0, std::numbers::pi / 2.0});
  QVERIFY((placed(quarter, kMiddle) - placed(pose, kMiddle)).norm() < 1e-12);
  // A quarter about the sight: what was on the right is below.
  const Eigen::Vector3d beside = kMiddle + Eigen::Vector3d(0.05, 0, 0);
  const Eigen::Vector3d away = placed(quarter, beside) - placed(quarter, kMiddle);
  QVERIFY((away - Eigen::Vector3d(0, 0.05, 0)).norm() < 1e-12);
  QVERIFY(turned(pose, kMiddle, Eigen::Vector3d::Zero()).rotation == pose.rotation);
}

void HandPoseTest::NearerStaysOnItsRay() {
  const CameraFromCt pose = upright_before(kMiddle, {0.01, 0.02, 0.14});
  const CameraFromCt near = at_distance(pose, kMiddle, 0.5);
  QVERIFY((camera().project(placed(near, kMiddle)) - camera().project(placed(pose, kMiddle))).norm() < 1e-9);
  QVERIFY(std::abs(placed(near, kMiddle).z() - 0.07) < 1e-12);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, at_distance(pose, kMiddle, 0.0));
}

QTEST_APPLESS_MAIN(HandPoseTest)
#include "hand_pose_test.moc"
