// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/bridges.h"

#include <QTest>

#include "glisson/core/error.h"

using namespace glisson;
using namespace glisson::editing;

namespace {

constexpr Label kPortal = structure::kPortalVein, kHepatic = structure::kHepaticVeins;

struct Tube {
  Eigen::Vector3d from, to;  // mm
  double radius;
};

/// Turned, shifted, with voxels that are no cubes.
VolumeGrid grid() {
  VolumeGrid grid;
  grid.size = {100, 90, 70};
  grid.spacing_mm = {0.8, 0.8, 1.2};
  grid.origin_mm = {-20, 35, 110};
  grid.direction << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  return grid;
}

Eigen::Vector3d place(const VolumeGrid& grid, int i, int j, int k) {
  return Eigen::Vector3d(i, j, k).cwiseProduct(grid.spacing_mm);
}
Point<CtFrame> at(const VolumeGrid& grid, const Eigen::Vector3d& mm) {
  return grid.p_in_ct(mm.cwiseQuotient(grid.spacing_mm));
}

bool in_tube(const Tube& tube, const Eigen::Vector3d& p) {
  const Eigen::Vector3d axis = tube.to - tube.from;
  const double t = std::clamp((p - tube.from).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
  return (p - tube.from - t * axis).norm() < tube.radius;
}

void draw(LabelVolume& labels, const Tube& tube, Label label) {
  const VolumeGrid& g = labels.grid();
  for (int k = 0; k < g.size.z(); ++k)
    for (int j = 0; j < g.size.y(); ++j)
      for (int i = 0; i < g.size.x(); ++i)
        if (in_tube(tube, place(g, i, j, k))) labels.set({i, j, k}, label);
}

/// How many of the voxels that satisfy `where` carry the label, and how many there are.
template <class Where>
std::pair<long, long> share(const LabelVolume& labels, Label label, Where&& where) {
  std::pair<long, long> count{0, 0};
  const VolumeGrid& g = labels.grid();
  for (int k = 0; k < g.size.z(); ++k)
    for (int j = 0; j < g.size.y(); ++j)
      for (int i = 0; i < g.size.x(); ++i) {
        if (!where(place(g, i, j, k))) continue;
        ++count.second;
        count.first += labels.at({i, j, k}) == label;
      }
  return count;
}

// A Y: a trunk, a left branch with a waist in the middle, a right one.
const Tube kTrunk{{40, 36, 8}, {40, 36, 40}, 5.0}, kRight{{40, 36, 40}, {66, 36, 64}, 2.6},
    kLeft{{40, 36, 40}, {26, 36, 52}, 3.0}, kWaist{{26, 36, 52}, {23, 36, 55}, 1.4},
    kFarLeft{{23, 36, 55}, {12, 36, 66}, 3.0};

LabelVolume y_tree() {
  LabelVolume labels(grid());
  for (const Tube& tube : {kTrunk, kRight, kLeft, kWaist, kFarLeft}) draw(labels, tube, kPortal);
  return labels;
}

}  // namespace

class BridgesTest : public QObject {
  Q_OBJECT
 private slots:
  void ContactOfTwoBarsHasTheirCommonArea();
  void EveryContactIsFoundLargestFirst();
  void TreesApartHaveNoBridge();
  void BranchBeyondTheWaistChangesSides();
  void CutStaysBehindTheFork();
  void AClickAtTheForkSparesTheTrunk_data();
  void AClickAtTheForkSparesTheTrunk();
  void TheRootDecidesWhatIsBeyond();
  void OnlyTheClickedPieceChanges();
  void AForeignPartIsSuspected();
  void ATreeThatTapersIsNotSuspected();
  void BadClicksAreRefused();
};

void BridgesTest::ContactOfTwoBarsHasTheirCommonArea() {
  LabelVolume labels(grid());
  // Bars along k, side by side along i: 5 x 6 faces of 0.8 mm x 1.2 mm touch.
  for (int k = 10; k < 30; ++k)
    for (int j = 20; j < 25; ++j)
      for (int i = 20; i < 23; ++i) labels.set({i, j, k}, kPortal);
  for (int k = 24; k < 50; ++k)
    for (int j = 20; j < 25; ++j)
      for (int i = 23; i < 27; ++i) labels.set({i, j, k}, kHepatic);
  const std::vector<Bridge> bridges = find_bridges({labels, {}});
  QCOMPARE(bridges.size(), std::size_t(1));
  QVERIFY(std::abs(bridges[0].contact_mm2 - 30 * 0.8 * 1.2) < 1e-9);
  QCOMPARE(bridges[0].voxels, 60L);
  const Eigen::Vector3d index = grid().index_of(bridges[0].p_in_ct);
  QVERIFY(index.x() > 21.9 && index.x() < 23.1);
  QVERIFY(std::abs(index.y() - 22.0) < 0.6 && std::abs(index.z() - 26.5) < 0.6);
}

void BridgesTest::EveryContactIsFoundLargestFirst() {
  LabelVolume labels(grid());
  draw(labels, {{40, 36, 8}, {40, 36, 76}, 4.0}, kPortal);
  // Crosses it at one height, and lies along it at another.
  draw(labels, {{16, 43.5, 20}, {64, 43.5, 20}, 4.0}, kHepatic);
  draw(labels, {{47.4, 36, 45}, {47.4, 36, 70}, 4.0}, kHepatic);
  const VolumeGrid g = grid();
  for (int k = 0; k < g.size.z(); ++k)  // the portal vein where both claim a voxel
    for (int j = 0; j < g.size.y(); ++j)
      for (int i = 0; i < g.size.x(); ++i)
        if (in_tube({{40, 36, 8}, {40, 36, 76}, 4.0}, place(g, i, j, k))) labels.set({i, j, k}, kPortal);
  const std::vector<Bridge> bridges = find_bridges({labels, {}});
  QCOMPARE(bridges.size(), std::size_t(2));
  QVERIFY(bridges[0].contact_mm2 > bridges[1].contact_mm2);
  const double along = bridges[0].p_in_ct.xyz.z(), across = bridges[1].p_in_ct.xyz.z();
  QVERIFY(std::abs(along - at(g, {44, 36, 57.5}).xyz.z()) < 4e-3);
  QVERIFY(std::abs(across - at(g, {40, 40, 20}).xyz.z()) < 3e-3);
}

void BridgesTest::TreesApartHaveNoBridge() {
  LabelVolume labels(grid());
  draw(labels, {{20, 36, 8}, {20, 36, 76}, 4.0}, kPortal);
  QVERIFY(find_bridges({labels, {}}).empty());
  draw(labels, {{60, 36, 8}, {60, 36, 76}, 4.0}, kHepatic);
  QVERIFY(find_bridges({labels, {}}).empty());
  QVERIFY(find_bridges({LabelVolume(grid()), {}}).empty());
}

void BridgesTest::BranchBeyondTheWaistChangesSides() {
  const LabelVolume before = y_tree();
  // A click a few mm beyond the waist, and one before it, cut at the waist.
  for (const Eigen::Vector3d& click : {Eigen::Vector3d(20, 36, 58), Eigen::Vector3d(27.5, 36.5, 50.5)}) {
    const LabelVolume after = reassign_branch(before, kPortal, kHepatic, at(grid(), click));
    const auto far =
        share(after, kHepatic, [](const Eigen::Vector3d& p) { return in_tube(kFarLeft, p) && p.x() < 21.0; });
    QCOMPARE(far.first, far.second);
    QVERIFY(far.second > 200);
    const auto near = share(after, kPortal, [](const Eigen::Vector3d& p) {
      return in_tube(kTrunk, p) || in_tube(kRight, p) || (in_tube(kLeft, p) && p.x() > 28.5);
    });
    QCOMPARE(near.first, near.second);
    // Nothing else is touched.
    QCOMPARE(after.histogram()[kPortal] + after.histogram()[kHepatic], before.histogram()[kPortal]);
  }
}

void BridgesTest::CutStaysBehindTheFork() {
  const LabelVolume before = y_tree();
  const LabelVolume after =
      reassign_branch(before, kPortal, structure::kBackground, at(grid(), {52, 36, 51}));
  const auto gone = share(after, structure::kBackground,
                          [](const Eigen::Vector3d& p) { return in_tube(kRight, p) && p.x() > 55.0; });
  QCOMPARE(gone.first, gone.second);
  const auto stays = share(after, kPortal, [](const Eigen::Vector3d& p) {
    return in_tube(kTrunk, p) || in_tube(kLeft, p) || in_tube(kWaist, p) || in_tube(kFarLeft, p);
  });
  QCOMPARE(stays.first, stays.second);
}

void BridgesTest::AClickAtTheForkSparesTheTrunk_data() {
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("z");
  QTest::addColumn<bool>("left");
  QTest::addColumn<bool>("right");
  QTest::newRow("left of the middle") << 37.5 << 41.5 << true << false;
  QTest::newRow("right of the middle") << 43.0 << 41.5 << false << true;
  QTest::newRow("before it, to the left") << 37.0 << 38.5 << true << false;
  QTest::newRow("before it, to the right") << 43.0 << 38.5 << false << true;
  QTest::newRow("the trunk, clearly") << 40.0 << 26.0 << true << true;
}

void BridgesTest::AClickAtTheForkSparesTheTrunk() {
  QFETCH(double, x);
  QFETCH(double, z);
  QFETCH(bool, left);
  QFETCH(bool, right);
  // The trunk's root is given: the thickest place of this tree is its fork.
  const LabelVolume before = y_tree();
  const LabelVolume after =
      reassign_branch(before, kPortal, kHepatic, at(grid(), {x, 36, z}), at(grid(), {40, 36, 8}));
  const auto moved = [&](auto&& where) {
    const auto [count, all] = share(after, kHepatic, where);
    return count == all ? 1 : count == 0 ? 0 : -1;
  };
  QCOMPARE(moved([](const Eigen::Vector3d& p) { return in_tube(kFarLeft, p) && p.x() < 20.0; }),
           left ? 1 : 0);
  QCOMPARE(moved([](const Eigen::Vector3d& p) { return in_tube(kRight, p) && p.x() > 52.0; }), right ? 1 : 0);
  QCOMPARE(moved([](const Eigen::Vector3d& p) { return in_tube(kTrunk, p) && p.z() < 18.0; }), 0);
  if (!left || !right)
    QCOMPARE(moved([](const Eigen::Vector3d& p) { return in_tube(kTrunk, p) && p.z() < 34.0; }), 0);
}

void BridgesTest::TheRootDecidesWhatIsBeyond() {
  const LabelVolume before = y_tree();
  // Seen from the left tip, everything but that tip's branch lies beyond the waist.
  const LabelVolume after =
      reassign_branch(before, kPortal, kHepatic, at(grid(), {24.5, 36, 53.5}), at(grid(), {12, 36, 66}));
  const auto rest = share(after, kHepatic, [](const Eigen::Vector3d& p) {
    return in_tube(kTrunk, p) || in_tube(kRight, p) || (in_tube(kLeft, p) && p.x() > 29.0);
  });
  QCOMPARE(rest.first, rest.second);
  const auto tip =
      share(after, kPortal, [](const Eigen::Vector3d& p) { return in_tube(kFarLeft, p) && p.x() < 20.0; });
  QCOMPARE(tip.first, tip.second);
}

void BridgesTest::OnlyTheClickedPieceChanges() {
  LabelVolume before = y_tree();
  // A thicker tree of the same label elsewhere: not this one's root.
  draw(before, {{40, 60, 10}, {40, 60, 60}, 7.0}, kPortal);
  const LabelVolume after = reassign_branch(before, kPortal, kHepatic, at(grid(), {20, 36, 58}));
  const auto other = share(after, kPortal, [](const Eigen::Vector3d& p) {
    return in_tube({{40, 60, 10}, {40, 60, 60}, 7.0}, p) || in_tube(kTrunk, p);
  });
  QCOMPARE(other.first, other.second);
  QVERIFY(after.histogram()[kHepatic] > 200);
  QVERIFY(!after.changes_since(before).empty());
  QVERIFY(after.changes_since(before).size() < before.brick_count() / 2);
}

void BridgesTest::AForeignPartIsSuspected() {
  // A branch of the portal tree ends at the side of a thick vessel, which was taken for its own.
  LabelVolume labels(grid());
  draw(labels, {{40, 36, 8}, {40, 36, 40}, 6.0}, kPortal);
  draw(labels, {{40, 36, 40}, {20, 36, 50}, 2.2}, kPortal);
  draw(labels, {{40, 36, 40}, {62, 36, 60}, 3.0}, kPortal);
  const Tube foreign{{15, 36, 20}, {15, 36, 76}, 4.5};
  draw(labels, foreign, kPortal);
  const std::vector<Joint> joints = find_joined({labels, {}});
  QVERIFY(!joints.empty());
  QCOMPARE(joints[0].tree, kPortal);
  QVERIFY(joints[0].widest_mm2 > 2.0 * joints[0].neck_mm2);
  const LabelVolume cut = reassign_branch(labels, kPortal, kHepatic, joints[0].p_in_ct);
  const auto right = share(cut, kHepatic, [&](const Eigen::Vector3d& p) { return in_tube(foreign, p); });
  QVERIFY2(right.first > 0.95 * right.second,
           qPrintable(QString("%1 of %2").arg(right.first).arg(right.second)));
  const auto own = share(cut, kPortal, [](const Eigen::Vector3d& p) {
    return in_tube({{40, 36, 8}, {40, 36, 40}, 6.0}, p) || in_tube({{40, 36, 40}, {62, 36, 60}, 3.0}, p);
  });
  QCOMPARE(own.first, own.second);
}

void BridgesTest::ATreeThatTapersIsNotSuspected() {
  LabelVolume labels(grid());
  draw(labels, {{40, 36, 8}, {40, 36, 34}, 5.0}, kHepatic);
  draw(labels, {{40, 36, 34}, {20, 36, 52}, 3.4}, kHepatic);
  draw(labels, {{40, 36, 34}, {60, 36, 52}, 3.4}, kHepatic);
  draw(labels, {{20, 36, 52}, {12, 36, 70}, 2.2}, kHepatic);
  draw(labels, {{20, 36, 52}, {28, 36, 70}, 2.2}, kHepatic);
  QVERIFY(find_joined({labels, {}}).empty());
  QVERIFY(find_joined({LabelVolume(grid()), {}}).empty());
}

void BridgesTest::BadClicksAreRefused() {
  const LabelVolume labels = y_tree();
  // Far from the tree; no such tree; in the root itself.
  QVERIFY_THROWS_EXCEPTION(InputError, reassign_branch(labels, kPortal, kHepatic, at(grid(), {70, 10, 10})));
  QVERIFY_THROWS_EXCEPTION(InputError, reassign_branch(labels, kHepatic, kPortal, at(grid(), {20, 36, 58})));
  LabelVolume ball(grid());
  draw(ball, {{40, 36, 40}, {40, 36, 40.1}, 6.0}, kPortal);
  QVERIFY_THROWS_EXCEPTION(InputError, reassign_branch(ball, kPortal, kHepatic, at(grid(), {40, 36, 40})));
}

QTEST_APPLESS_MAIN(BridgesTest)
#include "bridges_test.moc"
