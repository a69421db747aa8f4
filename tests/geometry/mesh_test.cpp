// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/mesh.h"

#include <Eigen/Geometry>
#include <QTest>
#include <numbers>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/topology.h"
#include "glisson/geometry/vertex_stars.h"
#include "shapes.h"

using namespace glisson;

namespace {

/// The unit cube in five tetrahedra, 1 m a side.
TetMesh cube() {
  TetMesh mesh;
  mesh.vertices.resize(8, 3);
  for (int i = 0; i < 8; ++i) mesh.vertices.row(i) << (i & 1), ((i >> 1) & 1), ((i >> 2) & 1);
  mesh.tetrahedra.resize(5, 4);
  mesh.tetrahedra << 0, 1, 2, 4, 3, 2, 1, 7, 5, 4, 7, 1, 6, 7, 4, 2, 1, 2, 4, 7;
  return mesh;
}

std::string complaint(const TetMesh& mesh) {
  return test::complaint([&] { check_tetrahedra(mesh, "mesh"); });
}

}  // namespace

class MeshTest : public QObject {
  Q_OBJECT
 private slots:
  void KnownSurfacesHaveTheirAreaAndVolume();
  void VolumeDoesNotDependOnThePlace();
  void CubeIsFilledByItsTetrahedra();
  void NormalsOfASphereAreRadial();
  void NormalsDoNotDependOnHowAFaceIsCut();
  void DegenerateTriangleHasZeroNormal();
  void DihedralAnglesOfKnownTetrahedra();
  void BoundaryIsTheCubesSurface();
  void EdgesKnowTheirTriangles();
  void OpenAndNonManifoldAreNotClosed();
  void ComponentsAreSplitLargestFirst();
  void EqualVerticesAreMerged();
  void CollapsedTrianglesGo();
  void SelectionKeepsTheOrder();
  void NeighboursOfAnIcosahedron();
  void CheckNamesWhatIsWrong();
  void OrientTurnsOnlyTheInverted();
  void SummaryOfKnownDistances();
  void DistancesOfConcentricSpheres();
  void SamplesLieOnTheSurfaceEvenly();
  void PointErrorsNeedAsManyPoints();
};

void MeshTest::KnownSurfacesHaveTheirAreaAndVolume() {
  const TriangleMesh box = test::box({2, 3, 4}), ball = test::sphere(1.0, 5),
                     ring = test::torus(3.0, 1.0, 300, 150);
  QVERIFY(std::abs(area(box) - 52.0) < 1e-12);
  QVERIFY(std::abs(volume(box) - 24.0) < 1e-12);
  QVERIFY(std::abs(area(ball) / (4 * std::numbers::pi) - 1.0) < 2e-3);
  QVERIFY(std::abs(volume(ball) / (4.0 / 3.0 * std::numbers::pi) - 1.0) < 2e-3);
  QVERIFY(std::abs(volume(ring) / (2 * std::numbers::pi * std::numbers::pi * 3.0) - 1.0) < 2e-3);
  QVERIFY(centroid(box).norm() < 1e-12);
  QCOMPARE(triangle_areas(box).size(), 12L);
}

void MeshTest::VolumeDoesNotDependOnThePlace() {
  const TriangleMesh ball = test::sphere(0.06, 3);
  QVERIFY(std::abs(volume(test::moved(ball, {1e4, -2e4, 3e3})) / volume(ball) - 1.0) < 1e-6);
}

void MeshTest::CubeIsFilledByItsTetrahedra() {
  const TetMesh mesh = cube();
  QVERIFY(std::abs(volume(mesh) - 1.0) < 1e-15);
  const Eigen::VectorXd volumes = tetrahedron_volumes(mesh);
  for (int t = 0; t < 4; ++t) QVERIFY(std::abs(volumes[t] - 1.0 / 6.0) < 1e-15);
  QVERIFY(std::abs(volumes[4] - 1.0 / 3.0) < 1e-15);
}

void MeshTest::NormalsOfASphereAreRadial() {
  const TriangleMesh ball = test::sphere(0.5, 3);
  const Points at_vertices = vertex_normals(ball), at_triangles = triangle_normals(ball);
  for (int i = 0; i < ball.vertex_count(); ++i)
    QVERIFY(at_vertices.row(i).dot(ball.vertices.row(i).normalized()) > 0.999);
  for (int t = 0; t < ball.triangle_count(); ++t) QVERIFY(std::abs(at_triangles.row(t).norm() - 1.0) < 1e-12);
}

void MeshTest::NormalsDoNotDependOnHowAFaceIsCut() {
  // At a box's corner each face fills a right angle, in one triangle or in two: weighted by angle the normal
  // is the diagonal, and it turns with the box.
  TriangleMesh box = test::box({0.1, 0.05, 0.02});
  const VertexStars stars(box);
  const Eigen::RowVector3d middle = box.vertices.colwise().mean();
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Points diagonals = (box.vertices.rowwise() - middle).cwiseSign() / std::sqrt(3.0) * turn.transpose();
  box.vertices = (box.vertices * turn.transpose()).eval();
  const Points normals = vertex_normals(box);
  for (int i = 0; i < box.vertex_count(); ++i) {
    QVERIFY((normals.row(i) - diagonals.row(i)).norm() < 1e-12);
    QVERIFY(stars.normal(box, i) == normals.row(i).transpose());
  }
}

void MeshTest::DegenerateTriangleHasZeroNormal() {
  TriangleMesh mesh;
  mesh.vertices = Points::Zero(3, 3);
  mesh.triangles.resize(1, 3);
  mesh.triangles << 0, 1, 2;
  QVERIFY(triangle_normals(mesh).isZero() && vertex_normals(mesh).isZero());
}

void MeshTest::DihedralAnglesOfKnownTetrahedra() {
  const Eigen::MatrixX2d angles = dihedral_angles(cube());
  // The one in the middle is regular; at the corners three faces are perpendicular.
  QVERIFY(std::abs(angles(4, 0) - 70.528779) < 1e-5 && std::abs(angles(4, 1) - 70.528779) < 1e-5);
  QVERIFY(std::abs(angles(0, 0) - 54.735610) < 1e-5 && std::abs(angles(0, 1) - 90.0) < 1e-9);
}

void MeshTest::BoundaryIsTheCubesSurface() {
  const BoundarySurface boundary = boundary_surface(cube());
  QCOMPARE(boundary.mesh.triangle_count(), 12);
  QCOMPARE(boundary.mesh.vertex_count(), 8);
  QVERIFY(is_closed(boundary.mesh));
  QVERIFY(std::abs(volume(boundary.mesh) - 1.0) < 1e-15);  // outwards
  const TetMesh mesh = cube();
  for (int t = 0; t < 12; ++t) {
    const auto tetrahedron = mesh.tetrahedra.row(boundary.tetrahedron_of_triangle[t]);
    for (int k = 0; k < 3; ++k)
      QVERIFY((tetrahedron.array() == boundary.node_of_vertex[boundary.mesh.triangles(t, k)]).any());
  }
}

void MeshTest::EdgesKnowTheirTriangles() {
  const std::vector<Edge> all = edges(test::box({1, 1, 1}));
  QCOMPARE(all.size(), std::size_t{18});
  for (const Edge& edge : all)
    QVERIFY(edge.a < edge.b && edge.left >= 0 && edge.right > edge.left && !edge.non_manifold);
}

void MeshTest::OpenAndNonManifoldAreNotClosed() {
  TriangleMesh open = test::box({1, 1, 1});
  open.triangles.conservativeResize(11, 3);
  QVERIFY(!is_closed(open));
  TriangleMesh fin = test::box({1, 1, 1});
  fin.vertices.conservativeResize(9, 3);
  fin.vertices.row(8) << 3, 3, 3;
  fin.triangles.conservativeResize(13, 3);
  fin.triangles.row(12) << 0, 1, 8;
  QVERIFY(!is_closed(fin));
  QVERIFY(!is_closed({}));
}

void MeshTest::ComponentsAreSplitLargestFirst() {
  const TriangleMesh both = test::joined(test::sphere(0.01, 1), test::moved(test::box({1, 1, 1}), {5, 0, 0}));
  int count = 0;
  const std::vector<int> component = connected_components(both, &count);
  QCOMPARE(count, 2);
  QCOMPARE(component.front(), 0);
  QCOMPARE(component.back(), 1);
  const std::vector<TriangleMesh> parts = split_components(both);
  QCOMPARE(parts.size(), std::size_t{2});
  QCOMPARE(parts[0].triangle_count(), 12);
  QVERIFY(std::abs(volume(parts[0]) - 1.0) < 1e-12);
}

void MeshTest::EqualVerticesAreMerged() {
  const TriangleMesh box = test::box({1, 1, 1});
  TriangleMesh soup;
  soup.vertices.resize(36, 3);
  soup.triangles.resize(12, 3);
  for (int t = 0; t < 12; ++t)
    for (int k = 0; k < 3; ++k) {
      soup.vertices.row(3 * t + k) = box.vertices.row(box.triangles(t, k));
      soup.triangles(t, k) = 3 * t + k;
    }
  QVERIFY(!is_closed(soup));
  std::vector<int> new_of_old;
  const TriangleMesh merged = merge_vertices(soup, 0.0, &new_of_old);
  QCOMPARE(merged.vertex_count(), 8);
  QVERIFY(is_closed(merged));
  for (int i = 0; i < 36; ++i) QVERIFY(merged.vertices.row(new_of_old[i]) == soup.vertices.row(i));
  soup.vertices += 1e-5 * Points::Random(36, 3);
  QCOMPARE(merge_vertices(soup, 0.0).vertex_count(), 36);
  QCOMPARE(merge_vertices(soup, 1e-3).vertex_count(), 8);
}

void MeshTest::CollapsedTrianglesGo() {
  TriangleMesh mesh;
  mesh.vertices.resize(4, 3);
  mesh.vertices << 0, 0, 0, 1e-6, 0, 0, 1, 0, 0, 0, 1, 0;
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 1, 2, 0, 2, 3;
  QCOMPARE(merge_vertices(mesh, 1e-4).triangle_count(), 1);
}

void MeshTest::SelectionKeepsTheOrder() {
  const TriangleMesh box = test::box({1, 1, 1});
  std::vector<int> kept;
  const TriangleMesh part = select_triangles(box, {4, 5}, &kept);
  QCOMPARE(part.triangle_count(), 2);
  QVERIFY(std::is_sorted(kept.begin(), kept.end()));
  for (int t = 0; t < 2; ++t)
    for (int k = 0; k < 3; ++k) QCOMPARE(kept[part.triangles(t, k)], box.triangles(4 + t, k));
}

void MeshTest::NeighboursOfAnIcosahedron() {
  for (const auto& ring : vertex_neighbours(test::sphere(1.0, 0))) {
    QCOMPARE(ring.size(), std::size_t{5});
    QVERIFY(std::is_sorted(ring.begin(), ring.end()));
  }
}

void MeshTest::CheckNamesWhatIsWrong() {
  QVERIFY(complaint(cube()).empty());
  QVERIFY(complaint({}).find("there are none") != std::string::npos);
  TetMesh mesh = cube();
  mesh.vertices(3, 1) = std::numeric_limits<double>::infinity();
  QVERIFY(complaint(mesh).find("vertex 3") != std::string::npos);
  mesh = cube();
  mesh.tetrahedra(2, 0) = 8;
  QVERIFY(complaint(mesh).find("tetrahedron 2") != std::string::npos);
  mesh = cube();
  std::swap(mesh.tetrahedra(1, 0), mesh.tetrahedra(1, 1));
  QVERIFY(complaint(mesh).find("inverted") != std::string::npos);
  mesh = cube();
  mesh.tetrahedra.row(3) << 0, 1, 2, 3;  // four corners of one face
  QVERIFY(complaint(mesh).find("flat") != std::string::npos);
  mesh = cube();
  mesh.tetrahedra.row(3) = mesh.tetrahedra.row(0);
  QVERIFY(complaint(mesh).find("same nodes as tetrahedron 0") != std::string::npos);
}

void MeshTest::OrientTurnsOnlyTheInverted() {
  TetMesh mesh = cube();
  std::swap(mesh.tetrahedra(1, 0), mesh.tetrahedra(1, 1));
  QCOMPARE(orient_tetrahedra(mesh), 1);
  QVERIFY(complaint(mesh).empty());
  QCOMPARE(orient_tetrahedra(mesh), 0);
}

void MeshTest::SummaryOfKnownDistances() {
  const DistanceSummary summary = summarise({4, 1, 3, 2, 10});
  QCOMPARE(summary.count, 5);
  QCOMPARE(summary.mean, 4.0);
  QCOMPARE(summary.median, 3.0);
  QCOMPARE(summary.maximum, 10.0);
  QVERIFY(std::abs(summary.rms - std::sqrt(26.0)) < 1e-12);
  QVERIFY(std::abs(summary.percentile_95 - 8.8) < 1e-12);
  QCOMPARE(summarise({}).mean, 0.0);
}

void MeshTest::DistancesOfConcentricSpheres() {
  const TriangleMesh inner = test::sphere(0.05, 4), outer = test::sphere(0.06, 4);
  const SurfaceDistance distance = surface_distance(inner, outer, 3000);
  QVERIFY(std::abs(distance.forward.mean - 0.01) < 2e-4);
  QVERIFY(std::abs(distance.backward.mean - 0.01) < 2e-4);
  QVERIFY(surface_distance(inner, inner, 1000).forward.maximum < 1e-12);
  QCOMPARE(distances_to_surface(inner.vertices, inner).size(),
           static_cast<std::size_t>(inner.vertex_count()));
}

void MeshTest::SamplesLieOnTheSurfaceEvenly() {
  const TriangleMesh box = test::box({1, 2, 3});
  const Points samples = sample_surface(box, 2200, 4);
  QVERIFY(sample_surface(box, 2200, 4) == samples);
  for (const double distance : distances_to_surface(samples, box)) QVERIFY(distance < 1e-12);
  int top = 0;  // the face z = 1.5 is 2 of 22 square metres
  for (Eigen::Index i = 0; i < samples.rows(); ++i) top += samples(i, 2) > 1.5 - 1e-9;
  QVERIFY(std::abs(top - 200) <= 3);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, sample_surface({}, 10, 1));
}

void MeshTest::PointErrorsNeedAsManyPoints() {
  Points a = Points::Zero(2, 3), b = a;
  b(1, 2) = 3.0;
  QCOMPARE(point_errors(a, b).mean, 1.5);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, point_errors(a, Points::Zero(3, 3)));
}

QTEST_APPLESS_MAIN(MeshTest)
#include "mesh_test.moc"
