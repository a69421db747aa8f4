// SPDX-License-Identifier: GPL-3.0-or-later
#include "connections.h"

#include <QTest>

#include "glisson/core/error.h"

using namespace glisson;
using namespace glisson::segmentation;

namespace {

constexpr Label kPortal = structure::kPortalVein, kHepatic = structure::kHepaticVeins;

VolumeGrid grid() {
  VolumeGrid grid;
  grid.size = {100, 60, 70};
  grid.spacing_mm = {0.8, 0.8, 1.2};
  return grid;
}

void draw(LabelMap& labels, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
          Label label) {
  const VolumeGrid& g = labels.voxels.grid();
  const Eigen::Vector3d axis = to - from;
  for (int k = 0; k < g.size.z(); ++k)
    for (int j = 0; j < g.size.y(); ++j)
      for (int i = 0; i < g.size.x(); ++i) {
        const Eigen::Vector3d p = Eigen::Vector3d(i, j, k).cwiseProduct(g.spacing_mm);
        const double t = std::clamp((p - from).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
        if ((p - from - t * axis).norm() < radius) labels.voxels.set({i, j, k}, label);
      }
}

LabelMap empty() { return {LabelVolume(grid()), {}}; }

/// A trunk of which three branches go, one of them forked: four tips.
LabelMap tree(double shift_mm = 0.0) {
  LabelMap labels = empty();
  const Eigen::Vector3d s(0, shift_mm, 0);
  draw(labels, s + Eigen::Vector3d(40, 24, 6), s + Eigen::Vector3d(40, 24, 36), 5.0, kPortal);
  draw(labels, s + Eigen::Vector3d(40, 24, 36), s + Eigen::Vector3d(14, 24, 56), 2.4, kPortal);
  draw(labels, s + Eigen::Vector3d(40, 24, 36), s + Eigen::Vector3d(40, 38, 64), 2.4, kPortal);
  draw(labels, s + Eigen::Vector3d(40, 24, 36), s + Eigen::Vector3d(58, 24, 50), 3.0, kPortal);
  draw(labels, s + Eigen::Vector3d(58, 24, 50), s + Eigen::Vector3d(74, 24, 52), 2.0, kPortal);
  draw(labels, s + Eigen::Vector3d(58, 24, 50), s + Eigen::Vector3d(60, 24, 72), 2.0, kPortal);
  return labels;
}

/// All but where the trunk comes from: its cut end is no tip.
std::vector<std::uint8_t> liver() {
  const VolumeGrid g = grid();
  std::vector<std::uint8_t> mask(static_cast<std::size_t>(g.voxel_count()), 1);
  std::fill(mask.begin(), mask.begin() + g.offset({0, 0, 10}), std::uint8_t{0});
  return mask;
}

void erase(LabelMap& labels, const Eigen::Vector3d& centre, double radius) {
  draw(labels, centre, centre + Eigen::Vector3d(1e-3, 0, 0), radius, structure::kBackground);
}

}  // namespace

class ConnectionsTest : public QObject {
  Q_OBJECT
 private slots:
  void ATreeHasItsOwnWays();
  void AMissingBranchIsOneWayLess();
  void AGapNearTheRootCutsAllBeyondIt();
  void ABorrowedBranchDoesNotCount();
  void ASmallShiftIsNoLoss();
  void HepaticVeinsMeetInTheCava();
  void OnlyTipsInTheLiverCount();
  void BadOptionsAreRefused();
};

void ConnectionsTest::ATreeHasItsOwnWays() {
  const Connections own = count_connections(tree(), tree(), kPortal, liver());
  QCOMPARE(own.ways, 4);
  QCOMPARE(own.found, 4);
  const Connections none = count_connections(tree(), empty(), kPortal, liver());
  QCOMPARE(none.ways, 4);
  QCOMPARE(none.found, 0);
  QCOMPARE(count_connections(empty(), tree(), kPortal, liver()).ways, 0);
}

void ConnectionsTest::AMissingBranchIsOneWayLess() {
  LabelMap found = tree();
  draw(found, {62, 24, 50.5}, {76, 24, 52.5}, 3.5, structure::kBackground);
  const Connections lost = count_connections(tree(), found, kPortal, liver());
  QCOMPARE(lost.ways, 4);
  QCOMPARE(lost.found, 3);
  // What was found is all true.
  const Connections kept = count_connections(found, tree(), kPortal, liver());
  QCOMPARE(kept.ways, kept.found);
}

void ConnectionsTest::AGapNearTheRootCutsAllBeyondIt() {
  LabelMap found = tree();
  erase(found, {50, 24, 44}, 4.5);
  const Connections lost = count_connections(tree(), found, kPortal, liver());
  QCOMPARE(lost.ways, 4);
  QCOMPARE(lost.found, 2);
}

void ConnectionsTest::ABorrowedBranchDoesNotCount() {
  LabelMap found = tree();
  draw(found, {36, 24, 39}, {14, 24, 56}, 2.6, kHepatic);
  QCOMPARE(count_connections(tree(), found, kPortal, liver()).found, 3);
}

void ConnectionsTest::ASmallShiftIsNoLoss() {
  QCOMPARE(count_connections(tree(), tree(1.6), kPortal, liver()).found, 4);
  // Ten millimetres aside it is another tree.
  QCOMPARE(count_connections(tree(), tree(10.0), kPortal, liver()).found, 0);
}

void ConnectionsTest::HepaticVeinsMeetInTheCava() {
  LabelMap truth = empty();
  draw(truth, {40, 24, 4}, {40, 24, 80}, 6.0, structure::kVenaCava);
  draw(truth, {32.5, 24, 50}, {8, 24, 20}, 3.0, kHepatic);
  draw(truth, {47.5, 24, 50}, {72, 24, 20}, 3.0, kHepatic);
  const Connections own = count_connections(truth, truth, kHepatic, liver());
  QCOMPARE(own.ways, 2);  // and not the ends of the cava
  QCOMPARE(own.found, 2);
  QCOMPARE(count_connections(truth, truth, kPortal, liver()).ways, 0);
}

void ConnectionsTest::OnlyTipsInTheLiverCount() {
  std::vector<std::uint8_t> right(liver().size(), 0);
  const VolumeGrid g = grid();
  for (int k = 0; k < g.size.z(); ++k)
    for (int j = 0; j < g.size.y(); ++j)
      for (int i = 50; i < g.size.x(); ++i) right[static_cast<std::size_t>(g.offset({i, j, k}))] = 1;
  QCOMPARE(count_connections(tree(), tree(), kPortal, right).ways, 3);
}

void ConnectionsTest::BadOptionsAreRefused() {
  const auto refused = [](ConnectionOptions options) {
    QVERIFY_THROWS_EXCEPTION(InputError, count_connections(tree(), tree(), kPortal, liver(), options));
  };
  refused({0.0, 3.0, 0.9});
  refused({10.0, 0.0, 0.9});
  refused({10.0, 3.0, 1.1});
  QVERIFY_THROWS_EXCEPTION(PreconditionError, count_connections(tree(), tree(), kPortal, {1, 0}));
}

QTEST_APPLESS_MAIN(ConnectionsTest)
#include "connections_test.moc"
