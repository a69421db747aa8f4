// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenery.h"

#include <QTest>
#include <optional>

#include "filmed_phantom.h"
#include "seen_parts.h"

using namespace glisson;
using namespace glisson::guidance;

namespace {

RigidMotion motion(double turn, const Eigen::Vector3d& way) {
  return {rotation_by(turn * Eigen::Vector3d(0.3, 1.0, -0.5).normalized()), way};
}

}  // namespace

class SceneryTest : public QObject {
  Q_OBJECT
 private slots:
  void TheWallTellsTheScopesMotion();
  void AnOrganThatMovesBeforeAWallIsNotTheScope();
  void WhatMovesByItselfIsOutvotedByTheRest();
  void AWallInHalvesTellsNothing();
  void NoWallTellsNothing();
  void TheOrganItselfIsNoScenery();
  void AFrameThatIsForgottenDoesNotCount();

 private:
  /// Follows the wall through frames; empty: nothing was told in the last one.
  std::optional<RigidMotion> told(const std::vector<phantom::Wall>& walls, const std::vector<Points>& organs,
                                  const RigidMotion& otherwise = {});
  TriangleMesh surface(const Points& nodes) const {
    TriangleMesh mesh = model_.surface.mesh;
    for (int i = 0; i < mesh.vertex_count(); ++i)
      mesh.vertices.row(i) = nodes.row(model_.surface.node_of_vertex[static_cast<std::size_t>(i)]);
    return mesh;
  }

  StereoRig rig_ = phantom::rig();
  PatientModel model_ = phantom::model(8, 6, 3);
  CameraFromCt view_ = [] {
    CameraFromCt view = phantom::view();
    view.translation.y() -= 30e-3;  // the wall in sight below
    return view;
  }();
  Points nodes_ = view_.apply(model_.mesh.vertices);
  int found_ = 0;
};

std::optional<RigidMotion> SceneryTest::told(const std::vector<phantom::Wall>& walls,
                                             const std::vector<Points>& organs,
                                             const RigidMotion& otherwise) {
  FollowerOptions options;
  options.points = 200;
  StereoFollower follower(rig_, options);
  Scenery scenery(rig_);
  FrameClock clock;
  std::optional<RigidMotion> result;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const StereoFrame frame = phantom::film(model_, organs[k], rig_, static_cast<int>(k),
                                            walls[k].depth > 0.0 ? &walls[k] : nullptr);
    clock.tick(frame.seconds);
    if (k == 0) {
      follower.begin(frame, seen_parts(frame, rig_, {}));
      scenery.replenish(follower, surface(organs[k]), {}, clock);
      found_ = scenery.count();
      continue;
    }
    follower.follow(frame);
    const auto step = scenery.follow(follower, otherwise, organs[k].colwise().mean().transpose());
    if (!step) return std::nullopt;
    result = step->after(result.value_or(RigidMotion{}));
  }
  return result;
}

void SceneryTest::TheWallTellsTheScopesMotion() {
  std::vector<phantom::Wall> walls(4);
  std::vector<Points> organs(4, nodes_);
  for (int k = 1; k < 4; ++k) {
    walls[static_cast<std::size_t>(k)].camera_from_wall =
        motion(0.012 * k, {2e-3 * k, -1e-3 * k, 1.5e-3 * k});
    organs[static_cast<std::size_t>(k)] = walls[static_cast<std::size_t>(k)].camera_from_wall.apply(nodes_);
  }
  // Without a first guess: the organ's points had told nothing.
  const auto found = told(walls, organs);
  QVERIFY(found);
  const double error = (found->apply(nodes_) - organs.back()).rowwise().norm().maxCoeff();
  QVERIFY2(error < 1e-3, qPrintable(QString::number(1e3 * error)));
  QVERIFY((nodes_ - organs.back()).rowwise().norm().minCoeff() > 4e-3);
}

void SceneryTest::AnOrganThatMovesBeforeAWallIsNotTheScope() {
  const std::vector<phantom::Wall> walls(4);
  std::vector<Points> organs;
  const RigidMotion step = motion(0.0, {0.0, -2e-3, -1e-3});
  for (int k = 0; k < 4; ++k) organs.push_back(k == 0 ? nodes_ : step.apply(organs.back()));
  const auto found = told(walls, organs, step);
  QVERIFY(found);
  const double error = (found->apply(nodes_) - nodes_).rowwise().norm().maxCoeff();
  QVERIFY2(error < 0.7e-3, qPrintable(QString::number(1e3 * error)));
}

void SceneryTest::WhatMovesByItselfIsOutvotedByTheRest() {
  std::vector<phantom::Wall> walls(4);
  for (int k = 0; k < 4; ++k) {
    walls[static_cast<std::size_t>(k)].torn_at = 0.05;  // by 9 mm in the end; right of it lie a quarter of the points
    walls[static_cast<std::size_t>(k)].torn_by = k * Eigen::Vector3d(0.0, 3e-3, 0.0);
  }
  const auto found = told(walls, std::vector<Points>(4, nodes_));
  QVERIFY(found);
  const double error = (found->apply(nodes_) - nodes_).rowwise().norm().maxCoeff();
  QVERIFY2(error < 1e-3, qPrintable(QString::number(1e3 * error)));
}

void SceneryTest::AWallInHalvesTellsNothing() {
  std::vector<phantom::Wall> walls(3);
  for (int k = 0; k < 3; ++k) {
    walls[static_cast<std::size_t>(k)].torn_at = 0.0;
    walls[static_cast<std::size_t>(k)].torn_by = k * Eigen::Vector3d(0.0, 4e-3, 0.0);
  }
  QVERIFY(!told(walls, std::vector<Points>(3, nodes_)));
}

void SceneryTest::NoWallTellsNothing() {
  phantom::Wall none;
  none.depth = 0.0;
  QVERIFY(!told({none, none}, {nodes_, nodes_}));
  QCOMPARE(found_, 0);
}

void SceneryTest::TheOrganItselfIsNoScenery() {
  // It is where it is drawn, and its texture is stronger than the wall's.
  const phantom::Wall wall;
  const StereoFrame frame = phantom::film(model_, nodes_, rig_, 0, &wall);
  FollowerOptions options;
  options.points = 200;
  StereoFollower follower(rig_, options);
  follower.begin(frame, seen_parts(frame, rig_, {}));
  FrameClock clock;
  clock.tick(0.0);
  Scenery scenery(rig_), masked(rig_);
  scenery.replenish(follower, surface(nodes_), {}, clock);
  QVERIFY2(scenery.count() >= 20, qPrintable(QString::number(scenery.count())));
  for (const FollowedPoint& point : scenery.points()) QVERIFY(point.p_in_camera.z() > 0.15);
  // Nor is what a mask covers.
  masked.replenish(follower, surface(nodes_), phantom::plain(rig_.left, 255), clock);
  QCOMPARE(masked.count(), 0);
}

void SceneryTest::AFrameThatIsForgottenDoesNotCount() {
  FollowerOptions options;
  options.points = 200;
  StereoFollower follower(rig_, options);
  Scenery scenery(rig_);
  FrameClock clock;
  phantom::Wall wall, moved;
  moved.camera_from_wall = motion(0.01, {1e-3, 1e-3, 0.0});
  const StereoFrame first = phantom::film(model_, nodes_, rig_, 0, &wall);
  clock.tick(first.seconds);
  follower.begin(first, seen_parts(first, rig_, {}));
  scenery.replenish(follower, surface(nodes_), {}, clock);
  StereoFrame black = first;
  black.left = black.right = phantom::plain(rig_.left, 0);
  follower.follow(black);
  follower.forget_last();  // as the tracker does, which then does not ask the scenery
  follower.follow(phantom::film(model_, moved.camera_from_wall.apply(nodes_), rig_, 2, &moved));
  const auto found = scenery.follow(follower, {}, nodes_.colwise().mean().transpose());
  QVERIFY(found);
  QVERIFY((found->apply(nodes_) - moved.camera_from_wall.apply(nodes_)).rowwise().norm().maxCoeff() < 1e-3);
}

QTEST_APPLESS_MAIN(SceneryTest)
#include "scenery_test.moc"
