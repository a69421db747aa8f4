// SPDX-License-Identifier: GPL-3.0-or-later
// The umbilical part of the portal vein's left branch is found by how the vein runs, and not where it is not.
#include "umbilical_part.h"

#include <QTest>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <numeric>

#include "../support/portal_trees.h"

using namespace glisson;
using namespace glisson::atlas;
using test::LeftBranch;

namespace {

const Eigen::Matrix3d kUpright = Eigen::Matrix3d::Identity();

/// The same tree with its nodes in another order, every other beam turned round, and another root.
VesselTree renumbered(const VesselTree& tree) {
  const auto count = static_cast<int>(tree.nodes.rows());
  VesselTree other = tree;
  const auto place = [&](int node) {
    return (node * 7 + 3) % count;
  };  // 7 and the count have no factor in common
  for (int i = 0; i < count; ++i) {
    other.nodes.row(place(i)) = tree.nodes.row(i);
    other.radii[static_cast<std::size_t>(place(i))] = tree.radii[static_cast<std::size_t>(i)];
  }
  for (std::size_t b = 0; b < tree.beams.size(); ++b) {
    other.beams[b] = {place(tree.beams[b][0]), place(tree.beams[b][1])};
    if (b % 2 == 0) std::swap(other.beams[b][0], other.beams[b][1]);
  }
  std::reverse(other.beams.begin(), other.beams.end());
  other.root = count / 2;
  return other;
}

/// Each beam in two.
VesselTree refined(const VesselTree& tree) {
  VesselTree fine = tree;
  fine.beams.clear();
  const auto count = tree.nodes.rows();
  fine.nodes.conservativeResize(count + static_cast<Eigen::Index>(tree.beams.size()), 3);
  for (std::size_t b = 0; b < tree.beams.size(); ++b) {
    const auto [from, to] = tree.beams[b];
    const auto middle = static_cast<int>(count) + static_cast<int>(b);
    fine.nodes.row(middle) = 0.5 * (tree.nodes.row(from) + tree.nodes.row(to));
    fine.radii.push_back(
        0.5 * (tree.radii[static_cast<std::size_t>(from)] + tree.radii[static_cast<std::size_t>(to)]));
    fine.beams.push_back({from, middle});
    fine.beams.push_back({middle, to});
  }
  return fine;
}

}  // namespace

class UmbilicalPartTest : public QObject {
  Q_OBJECT
 private slots:
  void itsEndIsFound() {
    const auto part = umbilical_part({test::portal_vein(LeftBranch::whole)}, kUpright);
    QVERIFY(part);
    QVERIFY2(part->tip.xyz.norm() < 0.004, qPrintable(QString::number(1e3 * part->tip.xyz.norm())));
    QVERIFY(part->base.xyz.y() > 0.01 && part->radius > 0.004);
  }

  void numberingAndRootDoNotCount() {
    const VesselTree tree = test::portal_vein(LeftBranch::whole);
    QVERIFY(std::gcd(static_cast<int>(tree.nodes.rows()), 7) == 1);
    const auto part = umbilical_part({tree}, kUpright), other = umbilical_part({renumbered(tree)}, kUpright);
    QVERIFY(part && other);
    QVERIFY((part->tip.xyz - other->tip.xyz).norm() < 1e-12);
    QVERIFY(std::abs(part->radius - other->radius) < 1e-12);
  }

  void samplingHardlyCounts() {
    const VesselTree tree = test::portal_vein(LeftBranch::whole);
    const auto part = umbilical_part({tree}, kUpright), other = umbilical_part({refined(tree)}, kUpright);
    QVERIFY(part && other);
    QVERIFY((part->tip.xyz - other->tip.xyz).norm() < 0.003);
  }

  void itMovesWithThePatient() {
    VesselTree tree = test::portal_vein(LeftBranch::whole);
    const auto part = umbilical_part({tree}, kUpright);
    const Eigen::Matrix3d turn(
        Eigen::AngleAxisd(2.1, Eigen::Vector3d(0.3, -0.5, 0.8).normalized()).toRotationMatrix());
    const Eigen::RowVector3d shift(0.2, -0.4, 0.7);
    tree.nodes = (tree.nodes * turn.transpose()).rowwise() + shift;
    const auto moved = umbilical_part({tree}, turn.transpose());
    QVERIFY(part && moved);
    QVERIFY((turn * part->tip.xyz + shift.transpose() - moved->tip.xyz).norm() < 1e-9);
  }

  /// A few degrees, as patients lie, make no other place of it, and none where there is none.
  void aLittleTurnHardlyCounts() {
    for (int axis = 0; axis < 3; ++axis)
      for (const double degrees : {-15.0, 15.0}) {
        const Eigen::Matrix3d turn(
            Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, Eigen::Vector3d::Unit(axis)));
        const auto part = umbilical_part({test::portal_vein(LeftBranch::whole)}, turn);
        QVERIFY(part);
        QVERIFY(part->tip.xyz.norm() < 0.012);
        QVERIFY(!umbilical_part({test::portal_vein(LeftBranch::none)}, turn));
        QVERIFY2(!umbilical_part({test::portal_vein(LeftBranch::transverse)}, turn),
                 qPrintable(QStringLiteral("%1 %2").arg(axis).arg(degrees)));
      }
  }

  void otherTreesShowNone_data() {
    QTest::addColumn<VesselTree>("tree");
    QTest::newRow("no left branch") << test::portal_vein(LeftBranch::none);
    QTest::newRow("ends in the transverse part") << test::portal_vein(LeftBranch::transverse);
    QTest::newRow("empty") << VesselTree();
    VesselTree beam;
    beam.nodes = Points::Random(2, 3);
    beam.radii = {0.005, 0.005};
    beam.beams = {{0, 1}};
    QTest::newRow("one beam") << beam;
  }

  void otherTreesShowNone() {
    QFETCH(VesselTree, tree);
    QVERIFY(!umbilical_part({tree}, kUpright));
  }

  void aThinBranchIsNone() {
    VesselTree tree = test::portal_vein(LeftBranch::whole);
    for (Eigen::Index i = 0; i < tree.nodes.rows(); ++i)
      if (tree.nodes(i, 0) > -0.01) tree.radii[static_cast<std::size_t>(i)] = 0.0015;
    QVERIFY(!umbilical_part({tree}, kUpright));
  }

  /// Pieces of a torn tree are trees: the one that shows it counts.
  void anyOfSeveralTrees() {
    const VesselTree whole = test::portal_vein(LeftBranch::whole), part = test::portal_vein(LeftBranch::none);
    const auto found = umbilical_part({part, whole, VesselTree()}, kUpright);
    QVERIFY(found && found->tip.xyz.norm() < 0.004);
    QVERIFY(!umbilical_part({}, kUpright));
  }
};

QTEST_APPLESS_MAIN(UmbilicalPartTest)
#include "umbilical_part_test.moc"
