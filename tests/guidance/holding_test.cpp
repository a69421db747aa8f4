// SPDX-License-Identifier: GPL-3.0-or-later
#include "holding.h"

#include <QTest>

#include "filmed_phantom.h"

using namespace glisson;
using namespace glisson::guidance;

class HoldingTest : public QObject {
  Q_OBJECT
 private slots:
  void AMotionOfAllIsFound();
  void WhatMovesInPartIsOutvoted();
  void ABreathIsBelievedAndALargeMotionOfAllNotWhole();
  void OrderDoesNotMatter();
  void WhatHoldsTheOrganStaysWhereAToolLifts_data();
  void WhatHoldsTheOrganStaysWhereAToolLifts();

 private:
  /// A curved face of the organ, seen from the front.
  static Points face() {
    Points rest(120, 3);
    for (int i = 0; i < 120; ++i) {
      const double x = 0.01 * (i % 12) - 0.055, y = 0.01 * (i / 12) - 0.045;
      rest.row(i) << x, y, 0.12 + 4.0 * (x * x + y * y);
    }
    return rest;
  }
  static std::vector<FollowedPoint> seen(const Points& places) {
    std::vector<FollowedPoint> points(static_cast<std::size_t>(places.rows()));
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i].id = static_cast<int>(i);
      points[i].p_in_camera = places.row(static_cast<Eigen::Index>(i)).transpose();
      const Eigen::Vector3d ray = points[i].p_in_camera.normalized();
      points[i].information = Eigen::Matrix3d::Identity() - 0.999 * ray * ray.transpose();
    }
    return points;
  }
  static double apart(const RigidMotion& a, const RigidMotion& b) {
    return (a.apply(face()) - b.apply(face())).rowwise().norm().maxCoeff();
  }
};

void HoldingTest::AMotionOfAllIsFound() {
  const RigidMotion truth{rotation_by({0.05, -0.1, 0.2}), {0.01, -0.02, 0.015}};
  QVERIFY(apart(common_to_most(face(), seen(truth.apply(face())), {}, {}), truth) < 1e-5);
}

void HoldingTest::WhatMovesInPartIsOutvoted() {
  // A hill of 25 mm over a third of the face.
  Points now = face();
  for (Eigen::Index i = 0; i < now.rows(); ++i)
    now(i, 1) -= 0.025 * std::exp(-(face().row(i) - face().row(14)).squaredNorm() / (0.03 * 0.03));
  const RigidMotion mean = fit_rigid_motion(face(), now, {});
  QVERIFY2(apart(mean, {}) > 6e-3, qPrintable(QString::number(1e3 * apart(mean, {}))));
  const double error = apart(common_to_most(face(), seen(now), mean, {}), {});
  QVERIFY2(error < 2e-3, qPrintable(QString::number(1e3 * error)));
}

void HoldingTest::ABreathIsBelievedAndALargeMotionOfAllNotWhole() {
  const RigidMotion breath{Eigen::Matrix3d::Identity(), {0.0, 8e-3, 0.0}},
      far{Eigen::Matrix3d::Identity(), {0.0, 60e-3, 0.0}};
  // The scene says that the scope stands.
  QVERIFY(apart(common_to_most(face(), seen(breath.apply(face())), {}, ExpectedMotion{{}, 8e-3, 0.05}),
                breath) < 0.5e-3);
  // A wall that says so against a whole organ 60 mm away is believed rather than the organ.
  QVERIFY(apart(common_to_most(face(), seen(far.apply(face())), {}, ExpectedMotion{{}, 8e-3, 0.05}), {}) <
          30e-3);
  QVERIFY(apart(common_to_most(face(), seen(far.apply(face())), {}, {}), far) < 1e-3);
}

void HoldingTest::OrderDoesNotMatter() {
  Points now = face(), turned = now, rest = now;
  for (Eigen::Index i = 0; i < now.rows(); ++i) now(i, 2) += 3e-3 * std::sin(50.0 * now(i, 0)) + 1e-3;
  for (Eigen::Index i = 0; i < now.rows(); ++i) {
    rest.row(i) = face().row(now.rows() - 1 - i);
    turned.row(i) = now.row(now.rows() - 1 - i);
  }
  QVERIFY(apart(common_to_most(face(), seen(now), {}, ExpectedMotion{{}, 8e-3, 0.05}),
                common_to_most(rest, seen(turned), {}, ExpectedMotion{{}, 8e-3, 0.05})) < 1e-9);
}

void HoldingTest::WhatHoldsTheOrganStaysWhereAToolLifts_data() {
  QTest::addColumn<bool>("wall");
  QTest::newRow("before a wall") << true;
  QTest::newRow("before nothing") << false;
}

void HoldingTest::WhatHoldsTheOrganStaysWhereAToolLifts() {
  // Most of the visible organ rises by up to 18 mm before a scope that moves. The cava stays where it is in
  // the body: with the common motion of all points it would go along by 16 mm.
  QFETCH(bool, wall);
  const StereoRig rig = phantom::rig();
  const PatientModel model = phantom::model(8, 6, 3);
  Registration start;
  start.camera_from_ct = phantom::view();
  start.camera_from_ct.translation.y() -= 30e-3;
  const Points nodes = start.nodes_in_camera = start.camera_from_ct.apply(model.mesh.vertices);
  TrackerOptions options;
  options.points = 80;
  options.judge.enabled = false;
  Tracker tracker(model, start, options);
  phantom::Wall behind;
  OverlayFrame overlay;
  constexpr int kFrames = 12;
  const RigidMotion step{rotation_by({0.0, 0.004, 0.0}), {0.5e-3, 0.0, 0.3e-3}};
  Eigen::Index top = 0;
  nodes.col(2).minCoeff(&top);
  const Eigen::RowVector3d under = nodes.row(top);
  for (int k = 0; k <= kFrames; ++k) {
    Points organ = nodes;
    for (Eigen::Index i = 0; i < organ.rows(); ++i)
      organ(i, 2) -= 1.5e-3 * k * std::exp(-(nodes.row(i) - under).squaredNorm() / (0.035 * 0.035));
    const StereoFrame frame =
        phantom::film(model, behind.camera_from_wall.apply(organ), rig, k, wall ? &behind : nullptr);
    if (k == 0) tracker.begin(rig, frame, {});
    overlay = tracker.follow(frame);
    QVERIFY(overlay.level() == Level::valid);
    if (k < kFrames) behind.camera_from_wall = step.after(behind.camera_from_wall);
  }
  const Binding cava = bind_points(model.mesh, model.landmarks.vena_cava);
  const double moved = point_errors(cava.apply(model.mesh, overlay.nodes_in_camera),
                                    behind.camera_from_wall.apply(cava.apply(model.mesh, nodes)))
                           .mean;
  QVERIFY2(moved < (wall ? 5.5e-3 : 8e-3), qPrintable(QString::number(1e3 * moved)));
}

QTEST_APPLESS_MAIN(HoldingTest)
#include "holding_test.moc"
