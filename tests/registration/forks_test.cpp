// SPDX-License-Identifier: GPL-3.0-or-later
// Which forks of the vessel trees are told of, and how far off they may be.
#include "glisson/registration/forks.h"

#include <QTest>

#include "glisson/patient/label_map.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

namespace {

/// Two large forks 30 mm apart, and a small one 3 mm behind the first.
///
///     root 0 - 1 < 2 < (3, 4)
///                < 5 < (6, 7)
///     and 8 hangs on 9, which lies between 1 and 2
VesselTree tree_of(Label structure) {
  VesselTree tree;
  tree.structure = structure;
  tree.nodes.resize(10, 3);
  tree.nodes << 0, 0, 0, 10, 0, 0, 25, 10, 0, 35, 15, 0, 35, 5, 0, 25, -20, 0, 35, -15, 0, 35, -25, 0, 13, 6,
      0, 12.5, 1.7, 0;
  tree.nodes *= 1e-3;
  tree.nodes.col(2).array() += 0.02;  // within the phantom
  tree.radii = {6e-3, 5e-3, 3e-3, 1e-3, 1e-3, 4e-3, 1e-3, 1e-3, 1e-3, 4.5e-3};
  tree.beams = {{0, 1}, {1, 9}, {9, 2}, {9, 8}, {2, 3}, {2, 4}, {1, 5}, {5, 6}, {5, 7}};
  tree.root = 0;
  return tree;
}

}  // namespace

class ForksTest : public QObject {
  Q_OBJECT
 private slots:
  void TheLargestComeFirstAndThoseBesideThemAreOne();
  void OnlyVeinsAreTold();
  void EachIsWhereItsTissueIsAndAsUnsure();
  void AnotherPlaceTakesThemAlong();
  void WhatIsKnownTurnsWithTheOrgan();
};

void ForksTest::TheLargestComeFirstAndThoseBesideThemAreOne() {
  const auto forks = largest_forks({tree_of(structure::kPortalVein)});
  QCOMPARE(forks.size(), std::size_t{3});
  QCOMPARE(forks[0].radius, 5e-3);  // and not the one 3 mm behind it
  QCOMPARE(forks[1].radius, 4e-3);
  QCOMPARE(forks[2].radius, 3e-3);
  QVERIFY((forks[2].place - Eigen::Vector3d(0.025, 0.01, 0.02)).norm() < 1e-12);
  QCOMPARE(largest_forks({tree_of(structure::kPortalVein)}, 1).size(), std::size_t{1});
}

void ForksTest::OnlyVeinsAreTold() {
  QVERIFY(largest_forks({tree_of(structure::kArtery)}).empty());
  const auto both = largest_forks({tree_of(structure::kHepaticVeins), tree_of(structure::kPortalVein)});
  QCOMPARE(both.size(), std::size_t{6});
  QCOMPARE(both[0].tree, structure::kPortalVein);
  QCOMPARE(both[3].tree, structure::kHepaticVeins);
}

void ForksTest::EachIsWhereItsTissueIsAndAsUnsure() {
  PatientModel model = phantom::model(7, 6, 3);
  model.vessels = {tree_of(structure::kPortalVein), tree_of(structure::kHepaticVeins)};
  const CameraFromCt pose = phantom::view();
  Registration registration;
  registration.camera_from_ct = pose;
  registration.nodes_in_camera = pose.apply(model.mesh.vertices);
  const LabelledCloud cloud =
      phantom::patch(model, registration.nodes_in_camera, {.share = 0.3, .noise = 1e-3, .seed = 1});
  const ErrorModel error(model, nullptr, {}, pose, registration.nodes_in_camera, prepare_cloud(cloud, {}),
                         1e-3);
  const std::vector<ForkSpread> forks = forks_of(model, registration, error);
  QCOMPARE(forks.size(), std::size_t{6});
  const Points place = Eigen::RowVector3d(0.01, 0.0, 0.02);
  QVERIFY((forks[0].centre.transpose() - pose.apply(place)).norm() < 1e-9);
  QCOMPARE(fork_name(forks[0]), std::string("portal_vein_fork_1"));
  QCOMPARE(fork_name(forks[5]), std::string("hepatic_veins_fork_3"));
  const auto there = error.covariances(model.mesh, bind_points(model.mesh, place));
  QVERIFY(forks[0].covariance.isApprox(there[0], 1e-9));
  QVERIFY(forks[3].covariance.isApprox(there[0], 1e-9));  // the other tree forks at the same place
}

void ForksTest::AnotherPlaceTakesThemAlong() {
  PatientModel model = phantom::model(7, 6, 3);
  model.vessels = {tree_of(structure::kPortalVein)};
  Registration registration;
  registration.forks.resize(3);
  registration.nodes_in_camera = model.mesh.vertices.rowwise() + Eigen::RowVector3d(0.0, 0.0, 0.1);
  place_forks(model, registration);
  QVERIFY((registration.forks[0].centre - Eigen::Vector3d(0.01, 0.0, 0.12)).norm() < 1e-9);
}

void ForksTest::WhatIsKnownTurnsWithTheOrgan() {
  PatientModel model = phantom::model(7, 6, 3);
  model.vessels = {tree_of(structure::kPortalVein)};
  const Eigen::Matrix3d along_x = Eigen::Vector3d(9e-6, 1e-6, 1e-6).asDiagonal();
  Registration registration;
  registration.nodes_in_camera = phantom::view().apply(model.mesh.vertices);
  registration.lesions = {{structure::kFirstLesion, along_x}};
  registration.forks.resize(3);
  for (ForkSpread& fork : registration.forks) fork.covariance = along_x;
  registration.covariances = symmetric_row(along_x).replicate(model.mesh.vertex_count(), 1);
  registration.rivals.resize(1);
  registration.expected = Eigen::VectorXd::Constant(model.mesh.vertex_count(), 2e-3);
  // A quarter turn about z, and away.
  Points nodes = registration.nodes_in_camera;
  nodes.col(0) = -registration.nodes_in_camera.col(1);
  nodes.col(1) = registration.nodes_in_camera.col(0);
  nodes.rowwise() += Eigen::RowVector3d(0.01, 0.02, 0.03);
  const Registration moved = carried_to(model, registration, nodes);
  const Eigen::Matrix3d along_y = Eigen::Vector3d(1e-6, 9e-6, 1e-6).asDiagonal();
  QVERIFY((moved.lesions[0].covariance - along_y).norm() < 1e-12);
  QVERIFY((moved.forks[0].covariance - along_y).norm() < 1e-12);
  QVERIFY((moved.covariances.row(5) - symmetric_row(along_y)).norm() < 1e-12);
  QVERIFY(moved.rivals.empty() && moved.expected == registration.expected);
  place_forks(model, registration);
  const Eigen::Vector3d was = registration.forks[0].centre;
  QVERIFY((moved.forks[0].centre - Eigen::Vector3d(0.01 - was.y(), 0.02 + was.x(), 0.03 + was.z())).norm() <
          1e-9);
}

QTEST_APPLESS_MAIN(ForksTest)
#include "forks_test.moc"
