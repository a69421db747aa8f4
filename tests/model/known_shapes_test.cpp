// SPDX-License-Identifier: GPL-3.0-or-later
// Vessels whose topology, lengths and radii are known in closed form.
#include <QTest>
#include <numbers>

#include "tubes.h"
#include "vessel_tree.h"

using namespace glisson;
using namespace glisson::test;
using model::FittedTree;
using model::SkeletonPath;

namespace {

const Eigen::Vector3d kCube(0.8, 0.8, 0.8), kSlab(0.7, 0.7, 2.0);  // millimetres: a CT's voxels, thick slices

double voxel_of(const Eigen::Vector3d& spacing) { return std::cbrt(spacing.prod()); }

/// Voxels to beams: what is drawn and calculated with.
struct Found {
  std::vector<SkeletonPath> paths;
  VesselTree tree;            ///< beams of 3 mm at most
  double curve_error = 0.0;   ///< millimetres
  double most_tolerance = 0;  ///< millimetres
};

Found found(const std::vector<Tube>& tubes, const Eigen::Vector3d& extent, const Eigen::Vector3d& spacing,
            const Eigen::Vector3d& root) {
  const VesselVoxels vessel = model::measure_vessel(voxels_of(tubes, extent, spacing));
  Found result;
  result.paths = model::skeleton(vessel, {voxel_at(vessel, root)}, {}).front();
  VolumeGrid grid = grid_of(vessel.mask);
  grid.origin_mm.setZero();
  const FittedTree fitted(vessel, grid, result.paths, 1);
  result.tree = fitted.sample({3.0, 1.0, 0.35});
  result.curve_error = fitted.curve_error_mm();
  result.most_tolerance = fitted.tolerance_mm();
  return result;
}

Eigen::Vector3d node_mm(const VesselTree& tree, int node) { return 1e3 * tree.nodes.row(node).transpose(); }

double length_mm(const VesselTree& tree) {
  double sum = 0.0;
  for (const auto& [a, b] : tree.beams) sum += (node_mm(tree, a) - node_mm(tree, b)).norm();
  return sum;
}

std::vector<int> degrees(const VesselTree& tree) {
  std::vector<int> degree(tree.radii.size(), 0);
  for (const auto& beam : tree.beams)
    for (const int node : beam) ++degree[static_cast<std::size_t>(node)];
  return degree;
}

int count_of(const VesselTree& tree, int degree) {
  const auto all = degrees(tree);
  return static_cast<int>(std::count(all.begin(), all.end(), degree));
}

struct Miss {
  double mean = 0.0, largest = 0.0;
};
/// Of the tree's nodes from the nearest of the tubes' true lines, millimetres.
Miss miss_of(const VesselTree& tree, const std::vector<Tube>& tubes) {
  std::vector<Eigen::Vector3d> lines;
  for (const Tube& tube : tubes)
    for (const Eigen::Vector3d& p : sampled(tube)) lines.push_back(p);
  Miss miss;
  for (int i = 0; i < tree.nodes.rows(); ++i) {
    const double far = distance_to(lines, node_mm(tree, i));
    miss.mean += far / static_cast<double>(tree.nodes.rows());
    miss.largest = std::max(miss.largest, far);
  }
  return miss;
}

/// Share of a tube's true line that lies within `reach` (mm) of the tree's beams.
double covered(const VesselTree& tree, const Tube& tube, double reach) {
  std::vector<Eigen::Vector3d> dense;
  for (const auto& [a, b] : tree.beams)
    for (int k = 0; k <= 8; ++k)
      dense.push_back(node_mm(tree, a) + (node_mm(tree, b) - node_mm(tree, a)) * k / 8.0);
  const auto line = sampled(tube);
  const auto inside = std::count_if(line.begin(), line.end(),
                                    [&](const Eigen::Vector3d& p) { return distance_to(dense, p) <= reach; });
  return static_cast<double>(inside) / static_cast<double>(line.size());
}

void say(const char* shape, const Found& it, const Miss& miss) {
  double low = 1e9, high = 0.0;
  for (const double radius : it.tree.radii) {
    low = std::min(low, 1e3 * radius);
    high = std::max(high, 1e3 * radius);
  }
  qInfo(
      "%s (%s): %zu paths, %d forks, length %.2f mm, off the line %.2f (%.2f) mm, radius %.2f to %.2f mm, "
      "curves within %.2f of %.2f mm",
      shape, QTest::currentDataTag(), it.paths.size(), count_of(it.tree, 3), length_mm(it.tree), miss.mean,
      miss.largest, low, high, it.curve_error, it.most_tolerance);
}

void both_voxels() {
  QTest::addColumn<double>("in_plane");
  QTest::addColumn<double>("slice");
  QTest::newRow("0.8 mm cubes") << kCube.x() << kCube.z();
  QTest::newRow("0.7 x 0.7 x 2 mm") << kSlab.x() << kSlab.z();
}

Eigen::Vector3d spacing_of_row() {
  QFETCH(double, in_plane);
  QFETCH(double, slice);
  return {in_plane, in_plane, slice};
}

}  // namespace

class KnownShapesTest : public QObject {
  Q_OBJECT
 private slots:
  void TorusIsOpenedOnce_data() { both_voxels(); }
  void TorusIsOpenedOnce();
  void YTubeHasOneForkAndItsRadii_data() { both_voxels(); }
  void YTubeHasOneForkAndItsRadii();
  void HelixHasItsLengthAndRadius_data() { both_voxels(); }
  void HelixHasItsLengthAndRadius();
  void TouchingTubesStayTwoLines_data() { both_voxels(); }
  void TouchingTubesStayTwoLines();
  void ObliqueTubeIsTheSameThroughThickSlices_data();
  void ObliqueTubeIsTheSameThroughThickSlices();
};

void KnownShapesTest::TorusIsOpenedOnce() {
  const double ring = 20.0, radius = 3.5;
  const Tube torus{[=](double t) -> Eigen::Vector3d {
                     const double angle = 2.0 * std::numbers::pi * t;
                     return {28 + ring * std::cos(angle), 28 + ring * std::sin(angle), 10};
                   },
                   radius};
  const Eigen::Vector3d spacing = spacing_of_row();
  const Found it = found({torus}, {56, 56, 20}, spacing, {28 + ring, 28, 10});
  const Miss miss = miss_of(it.tree, {torus});
  say("torus", it, miss);
  // A tree cannot close the ring: it runs around from the root on both sides, and the two ends meet.
  const double around = 2.0 * std::numbers::pi * ring;
  QVERIFY(it.paths.size() <= 2);
  QCOMPARE(count_of(it.tree, 1) - count_of(it.tree, 3), 2);  // one piece, no loop, no twig
  QVERIFY(length_mm(it.tree) > around - 2.0 * radius && length_mm(it.tree) < 1.05 * around);
  QVERIFY(covered(it.tree, torus, 0.75 * radius) > 0.97);
  QVERIFY(miss.mean < voxel_of(spacing));
  for (const double r : it.tree.radii) QVERIFY(std::abs(1e3 * r - radius) < 0.6 * voxel_of(spacing));
  QVERIFY(it.curve_error <= it.most_tolerance);
}

void KnownShapesTest::YTubeHasOneForkAndItsRadii() {
  const Eigen::Vector3d foot(30, 15, 8), fork(30, 15, 38), left(12, 15, 66), right(50, 15, 60);
  const std::vector<Tube> tubes = {straight(foot, fork, 5.0), straight(fork, left, 3.6),
                                   straight(fork, right, 2.6)};
  const Eigen::Vector3d spacing = spacing_of_row();
  const Found it = found(tubes, {60, 30, 76}, spacing, foot);
  const Miss miss = miss_of(it.tree, tubes);
  say("Y-tube", it, miss);
  QCOMPARE(it.paths.size(), std::size_t{2});
  QCOMPARE(count_of(it.tree, 3), 1);
  QCOMPARE(count_of(it.tree, 1), 3);
  const auto degree = degrees(it.tree);
  const int node = static_cast<int>(std::find(degree.begin(), degree.end(), 3) - degree.begin());
  QVERIFY2((node_mm(it.tree, node) - fork).norm() < 5.0, "the fork lies within the trunk's radius");
  double truth = 0.0;
  for (const Tube& tube : tubes) truth += (tube.line(1) - tube.line(0)).norm();
  // The lines may end in the round caps beyond the tubes' ends.
  QVERIFY(length_mm(it.tree) > 0.96 * truth && length_mm(it.tree) < truth + 5.0 + 3.6 + 2.6);
  QVERIFY(miss.mean < voxel_of(spacing));
  for (const Tube& tube : tubes) {
    QVERIFY(covered(it.tree, tube, 0.6 * tube.radius) > 0.9);
    const auto line = sampled(tube);
    for (int i = 0; i < it.tree.nodes.rows(); ++i) {
      const Eigen::Vector3d p = node_mm(it.tree, i);
      if ((p - fork).norm() < 9.0 || distance_to(line, p) > tube.radius) continue;
      QVERIFY(std::abs(1e3 * it.tree.radii[static_cast<std::size_t>(i)] - tube.radius) <
              0.75 * voxel_of(spacing));
    }
  }
  QVERIFY(it.curve_error <= it.most_tolerance);
}

void KnownShapesTest::HelixHasItsLengthAndRadius() {
  const double ring = 14.0, rise = 50.0, turns = 1.5, radius = 3.0;
  const Tube helix{[=](double t) -> Eigen::Vector3d {
                     const double angle = 2.0 * std::numbers::pi * turns * t;
                     return {20 + ring * std::cos(angle), 20 + ring * std::sin(angle), 8 + rise * t};
                   },
                   radius};
  const Eigen::Vector3d spacing = spacing_of_row();
  const Found it = found({helix}, {40, 40, 66}, spacing, helix.line(0));
  const Miss miss = miss_of(it.tree, {helix});
  say("helix", it, miss);
  QCOMPARE(it.paths.size(), std::size_t{1});
  const double truth = std::hypot(2.0 * std::numbers::pi * turns * ring, rise);
  // What the voxels' stairs add, and the caps.
  QVERIFY(length_mm(it.tree) > 0.97 * truth && length_mm(it.tree) < 1.03 * truth + 2.0 * radius);
  QVERIFY(miss.mean < voxel_of(spacing));
  for (const double r : it.tree.radii) QVERIFY(std::abs(1e3 * r - radius) < 0.6 * voxel_of(spacing));
  QVERIFY(it.curve_error <= it.most_tolerance);
}

void KnownShapesTest::TouchingTubesStayTwoLines() {
  const double radius = 3.0, length = 60.0;
  const Eigen::Vector3d spacing = spacing_of_row();
  // Their voxels hang together all along, as those of a portal branch and its neighbour may.
  const double apart = 2.0 * radius - 0.5 * spacing.x();
  const Tube one = straight({10, 12, 8}, {10, 12, 8 + length}, radius),
             other = straight({10 + apart, 12, 8}, {10 + apart, 12, 8 + length}, radius);
  const Found it = found({one, other}, {20 + apart, 24, 16 + length}, spacing, one.line(0));
  const Miss miss = miss_of(it.tree, {one, other});
  say("touching tubes", it, miss);
  QVERIFY(covered(it.tree, one, 0.5 * radius) > 0.93);
  QVERIFY(covered(it.tree, other, 0.5 * radius) > 0.93);
  // Two lines, and where the tree crosses from one into the other: no ladder of rungs.
  QVERIFY(it.paths.size() >= 2 && it.paths.size() <= 3);
  QVERIFY(length_mm(it.tree) > 2.0 * (length - radius) &&
          length_mm(it.tree) < 2.0 * length + 4.0 * radius + 2.0 * apart);
  QVERIFY(miss.mean < voxel_of(spacing));
  const auto in_other = [&](int node) { return node_mm(it.tree, node).x() > 10 + 0.5 * apart; };
  std::vector<Eigen::Vector3d> crossings;
  for (const auto& [a, b] : it.tree.beams)
    if (in_other(a) != in_other(b)) crossings.push_back(node_mm(it.tree, b));
  QVERIFY2(crossings.size() == 1, "the tree goes over from one tube to the other once");
  for (int i = 0; i < it.tree.nodes.rows(); ++i)
    if ((node_mm(it.tree, i) - crossings.front()).norm() > 3.0 * radius)
      QVERIFY(std::abs(1e3 * it.tree.radii[static_cast<std::size_t>(i)] - radius) < 0.6 * voxel_of(spacing));
  QVERIFY(it.curve_error <= it.most_tolerance);
}

void KnownShapesTest::ObliqueTubeIsTheSameThroughThickSlices_data() {
  QTest::addColumn<double>("slice");
  for (const double slice : {0.7, 1.5, 2.5})
    QTest::newRow(qPrintable(QStringLiteral("slices of %1 mm").arg(slice))) << slice;
}

void KnownShapesTest::ObliqueTubeIsTheSameThroughThickSlices() {
  QFETCH(double, slice);
  const Eigen::Vector3d spacing(0.7, 0.7, slice), from(12, 12, 12), to(48, 30, 42);
  const Tube tube = straight(from, to, 3.5);
  const Found it = found({tube}, {60, 42, 54}, spacing, from);
  const Miss miss = miss_of(it.tree, {tube});
  say("oblique tube", it, miss);
  QCOMPARE(it.paths.size(), std::size_t{1});
  QVERIFY(length_mm(it.tree) > (to - from).norm() && length_mm(it.tree) < (to - from).norm() + 2.0 * 3.5);
  QVERIFY(miss.mean < voxel_of(spacing));
  for (const double r : it.tree.radii) QVERIFY(std::abs(1e3 * r - 3.5) < 0.8 * voxel_of(spacing));
  QVERIFY(it.curve_error <= it.most_tolerance);
}

QTEST_APPLESS_MAIN(KnownShapesTest)
#include "known_shapes_test.moc"
