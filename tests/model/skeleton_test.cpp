// SPDX-License-Identifier: GPL-3.0-or-later
#include "skeleton.h"

#include <QTest>
#include <numbers>
#include <set>

#include "glisson/core/error.h"
#include "tubes.h"
#include "vessel_tree.h"

using namespace glisson;
using model::SkeletonOptions;
using model::SkeletonPath;
using model::VesselVoxels;
using namespace glisson::test;

namespace {

/// Mean distance of a path's voxels from the true line, the ends' caps (one radius) left out.
double mean_miss(const VesselVoxels& vessel, const SkeletonPath& path, const Tube& tube) {
  const auto line = sampled(tube);
  double sum = 0.0;
  int count = 0;
  for (const int voxel : path.voxels) {
    const Eigen::Vector3d p = vessel.position_mm(voxel);
    if ((p - line.front()).norm() < tube.radius || (p - line.back()).norm() < tube.radius) continue;
    sum += distance_to(line, p);
    ++count;
  }
  return sum / count;
}

const Eigen::Vector3d kSpacing(0.8, 0.8, 1.0);

Tube helix() {
  return {[](double t) -> Eigen::Vector3d {
            const double angle = 3.0 * std::numbers::pi * t;
            return {25 + 14 * std::cos(angle), 25 + 14 * std::sin(angle), 10 + 50 * t};
          },
          3.0};
}

std::vector<Tube> three_generations() {
  const Eigen::Vector3d a(30, 30, 6), b(30, 30, 30), c(14, 30, 48), d(46, 30, 48);
  return {straight(a, b, 4.0),         straight(b, c, 3.0),         straight(b, d, 3.0),
          straight(c, {6, 18, 66}, 2), straight(c, {6, 42, 66}, 2), straight(d, {54, 18, 66}, 2),
          straight(d, {54, 42, 66}, 2)};
}

}  // namespace

class SkeletonTest : public QObject {
  Q_OBJECT
 private slots:
  void RadiusIsTheDistanceToTheBoundary();
  void StraightTubeIsOnePath_data();
  void StraightTubeIsOnePath();
  void HelixIsFollowedInTheMiddle();
  void TheHeapAsPrintedIsNoWorseThanAccumulatedCost();
  void YTubeForksWhereItForks();
  void ThreeGenerationsGiveTheirBranches();
  void RoughSurfaceGivesNoBranches();
  void SmallBumpIsNoBranch();
  void PerpendicularBranchIsKept();
  void TwoRootsShareOnePiece();
  void PiecesAreCountedAndSorted();
  void ThickestEndIsFound();
  void LoopGivesNoEndlessPath();
  void PathsHangTogether();
  void BeamsFormATreeFromTheRoot();
  void ForkIsASharedNode();
  void BendsHaveMoreNodes();
  void BeamRadiiAreTheTubes();
  void PruningTakesTheThinnestLeaf();
  void OfBranchesAsThinTheShorterGoesFirst();
  void MaskWithoutMarginIsRefused();
  void RootOutsideIsRefused();
  void ImpossibleBeamLengthsAreRefused();
};

void SkeletonTest::RadiusIsTheDistanceToTheBoundary() {
  const Tube tube = straight({20, 20, 5}, {20, 20, 60}, 5.0);
  const VesselVoxels vessel = model::measure_vessel(voxels_of({tube}, {40, 40, 65}, {0.5, 0.5, 0.7}));
  for (double z = 15; z < 50; z += 5)
    QVERIFY(std::abs(vessel.radius_mm[voxel_at(vessel, {20, 20, z})] - 5.0) < 0.4);
  QVERIFY(std::abs(vessel.radius_mm[voxel_at(vessel, {23, 20, 30})] - 2.0) < 0.5);
}

void SkeletonTest::StraightTubeIsOnePath_data() {
  QTest::addColumn<double>("radius");
  QTest::addColumn<double>("slice");
  QTest::newRow("thin") << 2.0 << 1.0;
  QTest::newRow("thick") << 6.0 << 1.0;
  QTest::newRow("thick slices") << 4.0 << 2.0;
}

void SkeletonTest::StraightTubeIsOnePath() {
  QFETCH(double, radius);
  QFETCH(double, slice);
  const Tube tube = straight({12, 14, 10}, {26, 22, 70}, radius);
  const VesselVoxels vessel = model::measure_vessel(voxels_of({tube}, {40, 36, 80}, {0.8, 0.8, slice}));
  const auto paths = model::skeleton(vessel, {voxel_at(vessel, {12, 14, 10})}, {}).front();
  QCOMPARE(paths.size(), std::size_t{1});
  QVERIFY(mean_miss(vessel, paths[0], tube) < 0.8);
  QVERIFY((vessel.position_mm(paths[0].voxels.back()) - Eigen::Vector3d(26, 22, 70)).norm() < radius + 2.0);
}

void SkeletonTest::HelixIsFollowedInTheMiddle() {
  const VesselVoxels vessel = model::measure_vessel(voxels_of({helix()}, {50, 50, 70}, kSpacing));
  const auto paths = model::skeleton(vessel, {voxel_at(vessel, helix().line(0))}, {}).front();
  QCOMPARE(paths.size(), std::size_t{1});
  QVERIFY(mean_miss(vessel, paths[0], helix()) < 0.6);
  const model::FittedTree tree(vessel, grid_of(vessel.mask), paths, 2);
  const double truth = length_of(sampled(helix()));
  QVERIFY2(std::abs(tree.length_mm() - truth - helix().radius) < 0.06 * truth,
           qPrintable(QString::number(tree.length_mm() / truth)));
}

void SkeletonTest::TheHeapAsPrintedIsNoWorseThanAccumulatedCost() {
  const VesselVoxels vessel = model::measure_vessel(voxels_of({helix()}, {50, 50, 70}, kSpacing));
  double miss[2], length[2];
  for (const bool accumulated : {false, true}) {
    SkeletonOptions options;
    options.accumulated_cost = accumulated;
    const auto paths = model::skeleton(vessel, {voxel_at(vessel, helix().line(0))}, options).front();
    miss[accumulated] = mean_miss(vessel, paths[0], helix());
    std::vector<Eigen::Vector3d> line;
    for (const int voxel : paths[0].voxels) line.push_back(vessel.position_mm(voxel));
    length[accumulated] = length_of(line);
  }
  qInfo("as printed: %.3f mm off, %.1f mm long; accumulated: %.3f mm off, %.1f mm long", miss[0], length[0],
        miss[1], length[1]);
  QVERIFY(!SkeletonOptions{}.accumulated_cost);
  QVERIFY(miss[0] <= miss[1] + 0.05);
  QVERIFY(length[0] <= 1.01 * length[1]);
}

void SkeletonTest::YTubeForksWhereItForks() {
  const Eigen::Vector3d a(25, 20, 8), b(25, 20, 40), c(10, 20, 70), d(42, 20, 66);
  const VesselVoxels vessel = model::measure_vessel(
      voxels_of({straight(a, b, 4.0), straight(b, c, 3.0), straight(b, d, 2.5)}, {55, 40, 80}, kSpacing));
  const auto paths = model::skeleton(vessel, {voxel_at(vessel, a)}, {}).front();
  QCOMPARE(paths.size(), std::size_t{2});
  QCOMPARE(paths[1].parent, 0);
  QCOMPARE(paths[1].order, 1);
  QVERIFY((vessel.position_mm(paths[1].voxels.front()) - b).norm() < 5.0);
  std::set<int> reached;
  for (const auto& path : paths)
    for (const auto& tip : {c, d})
      if ((vessel.position_mm(path.voxels.back()) - tip).norm() < 5.0)
        reached.insert(static_cast<int>(tip.x()));
  QCOMPARE(reached.size(), std::size_t{2});
}

void SkeletonTest::ThreeGenerationsGiveTheirBranches() {
  const VesselVoxels vessel = model::measure_vessel(voxels_of(three_generations(), {60, 60, 75}, kSpacing));
  const auto paths = model::skeleton(vessel, {voxel_at(vessel, {30, 30, 6})}, {}).front();
  QCOMPARE(paths.size(), std::size_t{4});  // four tips, four paths
  std::multiset<int> orders;
  for (const auto& path : paths) orders.insert(path.order);
  QCOMPARE(orders.count(0), std::size_t{1});
  QCOMPARE(orders.count(1) + orders.count(2), std::size_t{3});
}

void SkeletonTest::RoughSurfaceGivesNoBranches() {
  const VesselVoxels vessel = model::measure_vessel(voxels_of({helix()}, {50, 50, 70}, kSpacing, 0.25));
  // Loose voxels beside the tube are pieces of their own.
  QVERIFY(model::vessel_pieces(vessel).front().size() > 5000);
  const auto paths = model::skeleton(vessel, {voxel_at(vessel, helix().line(0))}, {}).front();
  QCOMPARE(paths.size(), std::size_t{1});
}

void SkeletonTest::SmallBumpIsNoBranch() {
  const Tube tube = straight({20, 20, 8}, {20, 20, 70}, 4.0);
  const VesselVoxels vessel = model::measure_vessel(
      voxels_of({tube, straight({20, 20, 40}, {25, 20, 40}, 1.5)}, {40, 40, 80}, kSpacing));
  QCOMPARE(model::skeleton(vessel, {voxel_at(vessel, {20, 20, 8})}, {}).front().size(), std::size_t{1});
}

void SkeletonTest::PerpendicularBranchIsKept() {
  const Tube tube = straight({20, 20, 8}, {20, 20, 70}, 4.0);
  const VesselVoxels vessel = model::measure_vessel(
      voxels_of({tube, straight({20, 20, 40}, {45, 20, 40}, 2.0)}, {55, 40, 80}, kSpacing));
  const auto paths = model::skeleton(vessel, {voxel_at(vessel, {20, 20, 8})}, {}).front();
  QCOMPARE(paths.size(), std::size_t{2});
  QVERIFY((vessel.position_mm(paths[1].voxels.front()) - Eigen::Vector3d(20, 20, 40)).norm() < 3.0);
}

void SkeletonTest::TwoRootsShareOnePiece() {
  // Two vessels that touch: each root gets its own half.
  const Tube left = straight({10, 20, 8}, {19, 20, 60}, 3.0),
             right = straight({34, 20, 8}, {23, 20, 60}, 3.0);
  const VesselVoxels vessel = model::measure_vessel(voxels_of({left, right}, {45, 40, 70}, kSpacing));
  QCOMPARE(model::vessel_pieces(vessel).size(), std::size_t{1});
  const auto trees =
      model::skeleton(vessel, {voxel_at(vessel, left.line(0)), voxel_at(vessel, right.line(0))}, {});
  QCOMPARE(trees.size(), std::size_t{2});
  QVERIFY(mean_miss(vessel, trees[0].front(), left) < 1.2);
  QVERIFY(mean_miss(vessel, trees[1].front(), right) < 1.2);
}

void SkeletonTest::PiecesAreCountedAndSorted() {
  const VesselVoxels vessel = model::measure_vessel(
      voxels_of({straight({10, 10, 8}, {10, 10, 30}, 3.0), straight({30, 10, 8}, {30, 10, 60}, 3.0)},
                {40, 20, 70}, kSpacing));
  const auto pieces = model::vessel_pieces(vessel);
  QCOMPARE(pieces.size(), std::size_t{2});
  QVERIFY(pieces[0].size() > pieces[1].size());
}

void SkeletonTest::ThickestEndIsFound() {
  const Eigen::Vector3d a(20, 20, 8), b(20, 20, 60);
  for (const double thin : {2.0, 3.5}) {
    // Thick at a, thin at b, through a cone of short tubes.
    std::vector<Tube> tubes;
    for (int i = 0; i < 10; ++i)
      tubes.push_back(
          straight(a + 0.1 * i * (b - a), a + 0.1 * (i + 1) * (b - a), 5.0 + 0.1 * i * (thin - 5.0)));
    const VesselVoxels vessel = model::measure_vessel(voxels_of(tubes, {40, 40, 70}, kSpacing));
    const int end = model::thickest_end(vessel, model::vessel_pieces(vessel).front(), {}, nullptr);
    QVERIFY((vessel.position_mm(end) - a).norm() < 7.0);
    std::vector<float> favoured(vessel.mask.voxels.size(), 1.0F);
    for (std::size_t i = 0; i < favoured.size(); ++i)
      if (vessel.position_mm(static_cast<int>(i)).z() > 40) favoured[i] = 5.0F;
    const int other = model::thickest_end(vessel, model::vessel_pieces(vessel).front(), {}, &favoured);
    QVERIFY((vessel.position_mm(other) - b).norm() < 7.0);
  }
}

void SkeletonTest::LoopGivesNoEndlessPath() {
  const Tube ring{[](double t) -> Eigen::Vector3d {
                    return {30 + 18 * std::cos(2 * std::numbers::pi * t),
                            30 + 18 * std::sin(2 * std::numbers::pi * t), 10};
                  },
                  3.0};
  const VesselVoxels vessel = model::measure_vessel(voxels_of({ring}, {60, 60, 20}, kSpacing));
  const auto paths = model::skeleton(vessel, {voxel_at(vessel, {48, 30, 10})}, {}).front();
  double total = 0.0;
  for (const auto& path : paths) {
    std::vector<Eigen::Vector3d> line;
    for (const int voxel : path.voxels) line.push_back(vessel.position_mm(voxel));
    total += length_of(line);
  }
  // Both halves of the ring are found, neither twice.
  QVERIFY(total > 0.85 * 36 * std::numbers::pi && total < 1.2 * 36 * std::numbers::pi);
}

void SkeletonTest::PathsHangTogether() {
  const VesselVoxels vessel = model::measure_vessel(voxels_of(three_generations(), {60, 60, 75}, kSpacing));
  const auto paths = model::skeleton(vessel, {voxel_at(vessel, {30, 30, 6})}, {}).front();
  for (std::size_t p = 0; p < paths.size(); ++p) {
    // The first step leads from the middle of the parent's tube.
    for (std::size_t i = paths[p].parent < 0 ? 1 : 2; i < paths[p].voxels.size(); ++i)
      QVERIFY(((vessel.position_mm(paths[p].voxels[i]) - vessel.position_mm(paths[p].voxels[i - 1]))
                   .cwiseQuotient(kSpacing))
                  .cwiseAbs()
                  .maxCoeff() < 1.01);
    if (paths[p].parent < 0) continue;
    QVERIFY(paths[p].parent < static_cast<int>(p));
    QCOMPARE(paths[paths[p].parent].voxels[paths[p].parent_position], paths[p].voxels.front());
  }
}

void SkeletonTest::BeamsFormATreeFromTheRoot() {
  const VesselVoxels vessel = model::measure_vessel(voxels_of(three_generations(), {60, 60, 75}, kSpacing));
  const auto paths = model::skeleton(vessel, {voxel_at(vessel, {30, 30, 6})}, {}).front();
  const VesselTree tree = model::FittedTree(vessel, grid_of(vessel.mask), paths, 2).sample({});
  QCOMPARE(tree.beams.size() + 1, static_cast<std::size_t>(tree.nodes.rows()));
  QCOMPARE(tree.radii.size(), static_cast<std::size_t>(tree.nodes.rows()));
  std::vector<char> reached(tree.radii.size(), 0);
  reached[tree.root] = 1;
  for (const auto& [from, to] : tree.beams) {
    QVERIFY(reached[from] && !reached[to]);
    reached[to] = 1;
    const double length = (tree.nodes.row(from) - tree.nodes.row(to)).norm();
    QVERIFY(length > 0.5e-3 && length < 15e-3);
  }
  // In the CT's frame, metres: the grid's origin is at (10, -20, 30) mm.
  QVERIFY((tree.nodes.row(0) - 1e-3 * Eigen::RowVector3d(40, 10, 36)).norm() < 3e-3);
}

void SkeletonTest::ForkIsASharedNode() {
  const VesselVoxels vessel = model::measure_vessel(voxels_of(three_generations(), {60, 60, 75}, kSpacing));
  const auto paths = model::skeleton(vessel, {voxel_at(vessel, {30, 30, 6})}, {}).front();
  const VesselTree tree = model::FittedTree(vessel, grid_of(vessel.mask), paths, 2).sample({});
  std::vector<int> degree(tree.radii.size(), 0);
  for (const auto& beam : tree.beams)
    for (const int node : beam) ++degree[node];
  QCOMPARE(std::count(degree.begin(), degree.end(), 3), 3L);
  QCOMPARE(std::count(degree.begin(), degree.end(), 1), 5L);  // the root and four tips
}

void SkeletonTest::BendsHaveMoreNodes() {
  // A straight half, then a tight arc.
  const Tube tube{[](double t) -> Eigen::Vector3d {
                    if (t < 0.5) return {10, 20, 8 + 100 * t};
                    const double angle = 2.0 * (t - 0.5) * 1.5 * std::numbers::pi;
                    return {10 + 10 * (1 - std::cos(angle)), 20, 58 + 10 * std::sin(angle)};
                  },
                  2.5};
  const VesselVoxels vessel = model::measure_vessel(voxels_of({tube}, {45, 40, 85}, {0.7, 0.7, 0.7}));
  const auto paths = model::skeleton(vessel, {voxel_at(vessel, tube.line(0))}, {}).front();
  const VesselTree tree = model::FittedTree(vessel, grid_of(vessel.mask), paths, 2).sample({12.0, 2.0, 0.35});
  double sum[2] = {0.0, 0.0};
  int count[2] = {0, 0};
  for (const auto& [from, to] : tree.beams) {
    const bool bent = tree.nodes(to, 2) * 1e3 - 30 > 58 || tree.nodes(to, 0) * 1e3 - 10 > 14;
    sum[bent] += (tree.nodes.row(from) - tree.nodes.row(to)).norm();
    ++count[bent];
  }
  QVERIFY(count[0] > 0 && count[1] > 0);
  QVERIFY(sum[1] / count[1] < 0.6 * sum[0] / count[0]);
}

void SkeletonTest::BeamRadiiAreTheTubes() {
  const Eigen::Vector3d a(25, 20, 8), b(25, 20, 50);
  const VesselVoxels vessel = model::measure_vessel(voxels_of(
      {straight(a, b, 5.0), straight({25, 20, 30}, {55, 20, 45}, 2.0)}, {65, 40, 60}, {0.6, 0.6, 0.8}));
  const auto paths = model::skeleton(vessel, {voxel_at(vessel, a)}, {}).front();
  QCOMPARE(paths.size(), std::size_t{2});
  const VesselTree tree = model::FittedTree(vessel, grid_of(vessel.mask), paths, 2).sample({});
  for (Eigen::Index i = 0; i < tree.nodes.rows(); ++i) {
    const Eigen::Vector3d p = 1e3 * tree.nodes.row(i).transpose() - Eigen::Vector3d(10, -20, 30);
    if (p.x() > 34 && p.x() < 52) QVERIFY(std::abs(1e3 * tree.radii[i] - 2.0) < 0.5);
    if (std::abs(p.x() - 25) < 2 && (p.z() - 30 < -7 ? p.z() > 14 : p.z() > 40 && p.z() < 45))
      QVERIFY(std::abs(1e3 * tree.radii[i] - 5.0) < 0.7);
  }
}

void SkeletonTest::PruningTakesTheThinnestLeaf() {
  const Eigen::Vector3d a(25, 20, 8), b(25, 20, 60);
  const VesselVoxels vessel =
      model::measure_vessel(voxels_of({straight(a, b, 4.0), straight({25, 20, 25}, {50, 20, 35}, 1.6),
                                       straight({25, 20, 40}, {5, 20, 60}, 2.8)},
                                      {60, 40, 70}, kSpacing));
  const auto paths = model::skeleton(vessel, {voxel_at(vessel, a)}, {}).front();
  model::FittedTree tree(vessel, grid_of(vessel.mask), paths, 2);
  QCOMPARE(tree.branch_count(), 3);
  QVERIFY(tree.next_to_prune().radius_mm < 2.2);
  tree.prune(tree.next_to_prune());
  QCOMPARE(tree.branch_count(), 2);
  const VesselTree beams = tree.sample({});
  QVERIFY(beams.nodes.col(0).maxCoeff() < 40e-3);  // the thin one went to x = 60
  tree.prune(tree.next_to_prune());
  QCOMPARE(tree.branch_count(), 1);
  QCOMPARE(tree.next_to_prune().branch, -1);  // the trunk stays
  QVERIFY_THROWS_EXCEPTION(PreconditionError, tree.prune({}));
}

void SkeletonTest::OfBranchesAsThinTheShorterGoesFirst() {
  using Leaf = model::FittedTree::Leaf;
  const Leaf none, thin{1, 1.05, 40.0}, short_one{2, 1.20, 10.0}, thick{3, 1.9, 5.0};
  QVERIFY(short_one.before(thin) && !thin.before(short_one));
  QVERIFY(thin.before(thick) && !thick.before(thin));
  QVERIFY(thick.before(none) && !none.before(thick) && !none.before(none));
}

void SkeletonTest::MaskWithoutMarginIsRefused() {
  Mask mask({4, 4, 4}, {1, 1, 1});
  mask.voxels[mask.offset(0, 2, 2)] = 1;
  QVERIFY_THROWS_EXCEPTION(PreconditionError, model::measure_vessel(mask));
}

void SkeletonTest::RootOutsideIsRefused() {
  const VesselVoxels vessel =
      model::measure_vessel(voxels_of({straight({10, 10, 6}, {10, 10, 20}, 2.0)}, {20, 20, 26}, kSpacing));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, model::skeleton(vessel, {0}, {}));
}

void SkeletonTest::ImpossibleBeamLengthsAreRefused() {
  const VesselVoxels vessel =
      model::measure_vessel(voxels_of({straight({10, 10, 6}, {10, 10, 30}, 2.0)}, {20, 20, 36}, kSpacing));
  const auto paths = model::skeleton(vessel, {voxel_at(vessel, {10, 10, 6})}, {}).front();
  const model::FittedTree tree(vessel, grid_of(vessel.mask), paths, 2);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, tree.sample({1.0, 2.0, 0.35}));
}

QTEST_APPLESS_MAIN(SkeletonTest)
#include "skeleton_test.moc"
