// SPDX-License-Identifier: GPL-3.0-or-later
// Tubes around centrelines, against formulas: cylinders, an arc, a fork.
#include "vessel_tubes.h"

#include <Eigen/Geometry>
#include <QTest>
#include <cmath>

#include "glisson/geometry/topology.h"
#include "glisson/patient/label_map.h"

using namespace glisson;

namespace {

VesselTree tree_of(const std::vector<Eigen::Vector3d>& nodes, const std::vector<double>& radii,
                   const std::vector<std::array<int, 2>>& beams) {
  VesselTree tree;
  tree.structure = structure::kPortalVein;
  tree.nodes.resize(static_cast<Eigen::Index>(nodes.size()), 3);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    tree.nodes.row(static_cast<Eigen::Index>(i)) = nodes[i].transpose();
  tree.radii = radii;
  tree.beams = beams;
  tree.root = 0;
  return tree;
}

VesselTree line(double radius) {
  return tree_of({{0, 0, 0}, {0.02, 0, 0}, {0.04, 0, 0}}, {radius, radius, radius}, {{0, 1}, {1, 2}});
}

double volume_of(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    volume += mesh.vertex(mesh.triangles(t, 0))
                  .cross(mesh.vertex(mesh.triangles(t, 1)))
                  .dot(mesh.vertex(mesh.triangles(t, 2))) /
              6.0;
  return volume;
}

TriangleMesh tubes_of(const VesselTree& tree) {
  return scene::tubes_around(scene::vessel_courses({&tree}, 4000));
}

/// Of a point to the x axis.
double to_axis(const Eigen::Vector3d& p) { return std::hypot(p.y(), p.z()); }

}  // namespace

class VesselTubesTest : public QObject {
  Q_OBJECT
 private slots:
  void AStraightVesselIsACylinderWithRoundEnds();
  void TubesAreClosedAndWoundOutwards();
  void ABendFollowsItsArc();
  void ABranchBeginsWithItsOwnWidth();
  void ThinEndsAreLeftOut();
  void ManyBranchesKeepToTheirTriangles();
  void ARingHasAnEnd();
};

void VesselTubesTest::AStraightVesselIsACylinderWithRoundEnds() {
  const VesselTree tree = line(4e-3);
  const TriangleMesh mesh = tubes_of(tree);
  double farthest = 0.0;
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    const Eigen::Vector3d p = mesh.vertex(i);
    farthest = std::max(farthest, p.x());
    if (to_axis(p) < 1e-9) continue;  // the middle of an end
    const double beyond = std::max({0.0, -p.x(), p.x() - 0.04});
    QVERIFY(std::abs(std::hypot(to_axis(p), beyond) - 4e-3) < 1e-6);
  }
  QVERIFY2(farthest > 0.0438 && farthest <= 0.044, qPrintable(QString::number(farthest)));
}

void VesselTubesTest::TubesAreClosedAndWoundOutwards() {
  const VesselTree tree = line(4e-3);
  const TriangleMesh mesh = tubes_of(tree);
  for (const Edge& edge : edges(mesh)) QVERIFY(edge.right >= 0 && !edge.non_manifold);
  // A prism of ten sides, and less than two half balls.
  const double prism = 5.0 * std::sin(2.0 * M_PI / 10.0) * 16e-6 * 0.04;
  const double volume = volume_of(mesh);
  QVERIFY2(volume > prism && volume < prism + 4.0 / 3.0 * M_PI * 64e-9, qPrintable(QString::number(volume)));
}

void VesselTubesTest::ABendFollowsItsArc() {
  constexpr double kArc = 0.03;
  std::vector<Eigen::Vector3d> nodes;
  std::vector<std::array<int, 2>> beams;
  for (int i = 0; i < 7; ++i) {
    const double angle = 0.26 * i;
    nodes.emplace_back(kArc * std::cos(angle), kArc * std::sin(angle), 0.0);
    if (i > 0) beams.push_back({i - 1, i});
  }
  const VesselTree tree = tree_of(nodes, std::vector<double>(7, 3e-3), beams);
  const TriangleMesh mesh = tubes_of(tree);
  double worst = 0.0;
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    const Eigen::Vector3d p = mesh.vertex(i);
    const double angle = std::atan2(p.y(), p.x());
    if (angle < 0.05 || angle > 1.5) continue;
    const double from_arc = std::hypot(std::hypot(p.x(), p.y()) - kArc, p.z());
    worst = std::max(worst, std::abs(from_arc - 3e-3));
  }
  // A straight piece between two nodes would lie up to 0.25 mm inside.
  QVERIFY2(worst > 0.0 && worst < 1.8e-4, qPrintable(QString::number(1e3 * worst)));
}

void VesselTubesTest::ABranchBeginsWithItsOwnWidth() {
  const VesselTree tree = tree_of({{0, 0, 0}, {0.02, 0, 0}, {0.04, 0, 0}, {0.02, 0.03, 0}},
                                  {7e-3, 7e-3, 7e-3, 2e-3}, {{0, 1}, {1, 2}, {1, 3}});
  const TriangleMesh mesh = tubes_of(tree);
  int of_the_branch = 0;
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    const Eigen::Vector3d p = mesh.vertex(i);
    if (to_axis(p) < 7e-3 + 1e-6 || p.x() > 0.0405) continue;
    ++of_the_branch;
    QVERIFY(std::hypot(p.x() - 0.02, p.z()) < 2e-3 + 1e-6);
  }
  QVERIFY(of_the_branch > 100);
}

void VesselTubesTest::ThinEndsAreLeftOut() {
  // Thin in the middle, thick again, then thin to the end; and a thin branch.
  const VesselTree tree =
      tree_of({{0, 0, 0}, {0.02, 0, 0}, {0.04, 0, 0}, {0.06, 0, 0}, {0.08, 0, 0}, {0.02, 0.03, 0}},
              {3e-3, 1e-3, 3e-3, 1e-3, 1e-3, 1e-3}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {1, 5}});
  const TriangleMesh mesh = tubes_of(tree);
  QVERIFY(mesh.triangle_count() > 0);
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    QVERIFY(mesh.vertex(i).x() < 0.0431);
    QVERIFY(mesh.vertex(i).y() < 3.1e-3);
  }
  const VesselTree thin = line(1e-3);
  QCOMPARE(tubes_of(thin).triangle_count(), 0);
  QCOMPARE(scene::tubes_around(scene::vessel_courses({}, 4000)).triangle_count(), 0);
}

void VesselTubesTest::ManyBranchesKeepToTheirTriangles() {
  std::vector<VesselTree> trees(100, line(2e-3));
  std::vector<const VesselTree*> all;
  for (const VesselTree& tree : trees) all.push_back(&tree);
  std::size_t rings = 0;
  for (const auto& course : scene::vessel_courses(all, 20000)) rings += course.size();
  // Twenty triangles a ring.
  QVERIFY2(rings > 900 && rings < 1200, qPrintable(QString::number(rings)));
}

void VesselTubesTest::ARingHasAnEnd() {
  VesselTree tree = line(4e-3);
  tree.beams.push_back({2, 1});
  QVERIFY(tubes_of(tree).triangle_count() > 0);
}

QTEST_GUILESS_MAIN(VesselTubesTest)
#include "vessel_tubes_test.moc"
