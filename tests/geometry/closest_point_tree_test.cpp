// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/closest_point_tree.h"

#include <Eigen/Geometry>
#include <QTest>
#include <random>

#include "glisson/core/error.h"
#include "shapes.h"

using namespace glisson;

namespace {

std::mt19937 generator(5);

Eigen::Vector3d random_point(double scale) {
  std::uniform_real_distribution<double> uniform(-scale, scale);
  return {uniform(generator), uniform(generator), uniform(generator)};
}

/// Closest point by looking everywhere, each triangle by dense sampling of its plane and edges' formula.
double brute_distance(const TriangleMesh& mesh, const Eigen::Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Vector3d corners[3] = {mesh.vertex(mesh.triangles(t, 0)), mesh.vertex(mesh.triangles(t, 1)),
                                        mesh.vertex(mesh.triangles(t, 2))};
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    const Eigen::Vector3d foot = p - normal * normal.dot(p - corners[0]);
    bool inside = true;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d a = corners[k], b = corners[(k + 1) % 3];
      inside = inside && (b - a).cross(foot - a).dot(normal) >= 0.0;
      const double along = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      least = std::min(least, (p - a - along * (b - a)).norm());
    }
    if (inside) least = std::min(least, (p - foot).norm());
  }
  return least;
}

/// First hit by solving each triangle's 3x3 system.
double brute_hit(const TriangleMesh& mesh, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Vector3d a = mesh.vertex(mesh.triangles(t, 0));
    Eigen::Matrix3d system;
    system << mesh.vertex(mesh.triangles(t, 1)) - a, mesh.vertex(mesh.triangles(t, 2)) - a, -direction;
    const Eigen::Vector3d solution = system.fullPivLu().solve(origin - a);
    if (solution[0] >= 0 && solution[1] >= 0 && solution[0] + solution[1] <= 1 && solution[2] > 0)
      nearest = std::min(nearest, solution[2]);
  }
  return nearest;
}

}  // namespace

class ClosestPointTreeTest : public QObject {
  Q_OBJECT
 private slots:
  void init() { generator.seed(5); }  // no test's numbers depend on another's
  void ClosestIsWhatBruteForceFinds();
  void TheAnswerIsTheSameFromWhereverItIsSought();
  void BarycentricWeightsGiveThePoint();
  void RefitAnswersForTheMovedMesh();
  void AnswersAreExactAlongALongWayOfSmallMoves();
  void RadiusCutsOff();
  void ChosenTrianglesAloneAreSearched();
  void RayHitsWhatBruteForceHits();
  void RayAlongAnAxisInTheBoxPlaneHits();
  void RayParametersBoundTheHit();
  void EmptyMeshFindsNothing();
  void DegenerateTriangleIsNoTrap();
  void ATriangleThatIsALineIsItsEdges();
  void RefitWithOtherVerticesIsRefused();
};

void ClosestPointTreeTest::ClosestIsWhatBruteForceFinds() {
  for (const TriangleMesh& mesh :
       {test::sphere(0.06, 2), test::torus(0.05, 0.02, 20, 12), test::box({0.1, 0.05, 0.02})}) {
    const ClosestPointTree tree(mesh);
    for (int i = 0; i < 300; ++i) {
      const Eigen::Vector3d p = random_point(0.1);
      const ClosestPoint found = tree.closest(p);
      QVERIFY(std::abs(found.distance - brute_distance(mesh, p)) < 1e-12);
      QVERIFY(std::abs((found.point - p).norm() - found.distance) < 1e-15);
    }
  }
}

void ClosestPointTreeTest::TheAnswerIsTheSameFromWhereverItIsSought() {
  // On a box's grid of planes many triangles are equally near: the lowest must win, begun at any.
  for (const TriangleMesh& mesh : {test::torus(0.05, 0.02, 20, 12), test::box({0.1, 0.05, 0.02})}) {
    const ClosestPointTree tree(mesh);
    std::uniform_int_distribution<int> any(-1, mesh.triangle_count() - 1);
    for (int i = 0; i < 300; ++i) {
      const Eigen::Vector3d p =
          i < 20 ? Eigen::Vector3d(mesh.vertex(i % mesh.vertex_count())) : random_point(0.1);
      const ClosestPoint found = tree.closest(p), again = tree.closest_from(any(generator), p);
      QCOMPARE(again.triangle, found.triangle);
      QCOMPARE(again.distance, found.distance);
      QVERIFY(again.point == found.point && again.barycentric == found.barycentric);
    }
  }
}

void ClosestPointTreeTest::BarycentricWeightsGiveThePoint() {
  const TriangleMesh mesh = test::torus(0.05, 0.02, 20, 12);
  const ClosestPointTree tree(mesh);
  for (int i = 0; i < 100; ++i) {
    const ClosestPoint found = tree.closest(random_point(0.1));
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
      point += found.barycentric[k] * mesh.vertex(mesh.triangles(found.triangle, k));
    QVERIFY((point - found.point).norm() < 1e-14);
    QVERIFY(std::abs(found.barycentric.sum() - 1.0) < 1e-12 && found.barycentric.minCoeff() >= -1e-12);
  }
}

void ClosestPointTreeTest::RefitAnswersForTheMovedMesh() {
  TriangleMesh mesh = test::sphere(0.06, 2);
  ClosestPointTree tree(mesh);
  for (int i = 0; i < mesh.vertex_count(); ++i)
    mesh.vertices.row(i) += 0.3 * random_point(0.05).transpose() + Eigen::RowVector3d(0.1, 0, 0);
  tree.refit(mesh.vertices);
  const ClosestPointTree fresh(mesh);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d p = random_point(0.2);
    QVERIFY(std::abs(tree.closest(p).distance - brute_distance(mesh, p)) < 1e-12);
    QCOMPARE(tree.closest(p).distance, fresh.closest(p).distance);
  }
}

void ClosestPointTreeTest::AnswersAreExactAlongALongWayOfSmallMoves() {
  // A sheet of half a millimetre: where it lay before, the other face was the nearer one, and a ray along it
  // went by. Most of the moves change no box, together they change all.
  TriangleMesh mesh = test::box({0.1, 0.05, 0.0005});
  ClosestPointTree tree(mesh);
  std::uniform_real_distribution<double> about(-0.003, 0.003);
  for (int move = 0; move < 60; ++move) {
    mesh.vertices.rowwise() += 0.3e-3 * Eigen::RowVector3d(1, -1, 1);
    tree.refit(mesh.vertices);
    const Eigen::Vector3d middle = mesh.vertices.colwise().mean().transpose();
    for (int i = 0; i < 20; ++i) {
      const Eigen::Vector3d p = middle + Eigen::Vector3d(0.0, 0.0, about(generator));
      QVERIFY(std::abs(tree.closest(p).distance - brute_distance(mesh, p)) < 1e-12);
      const Eigen::Vector3d from = p - Eigen::Vector3d(0.2, 0.0, 0.0), along(1.0, 0.001, 0.0005);
      const ClosestPoint hit = tree.first_hit(from, along);
      const double expected = brute_hit(mesh, from, along);
      QCOMPARE(hit.triangle >= 0, std::isfinite(expected));
      if (hit.triangle >= 0) QVERIFY(std::abs(hit.distance - expected) < 1e-9);
    }
  }
}

void ClosestPointTreeTest::RadiusCutsOff() {
  const ClosestPointTree tree(test::sphere(0.06, 3));
  QCOMPARE(tree.closest({0.1, 0, 0}, 0.03).triangle, -1);
  QVERIFY(tree.closest({0.1, 0, 0}, 0.05).triangle >= 0);
}

void ClosestPointTreeTest::ChosenTrianglesAloneAreSearched() {
  const TriangleMesh mesh = test::sphere(0.06, 2);
  std::vector<int> upper;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    if (mesh.vertices(mesh.triangles(t, 0), 2) > 0 && mesh.vertices(mesh.triangles(t, 1), 2) > 0 &&
        mesh.vertices(mesh.triangles(t, 2), 2) > 0)
      upper.push_back(t);
  const ClosestPointTree tree(mesh, upper);
  const ClosestPoint found = tree.closest({0, 0, -0.1});
  QVERIFY(std::find(upper.begin(), upper.end(), found.triangle) != upper.end());
  QVERIFY(found.distance > 0.1);
}

void ClosestPointTreeTest::RayHitsWhatBruteForceHits() {
  for (const TriangleMesh& mesh : {test::sphere(0.06, 2), test::torus(0.05, 0.02, 20, 12)}) {
    const ClosestPointTree tree(mesh);
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
      const Eigen::Vector3d origin = random_point(0.15), direction = random_point(1.0);
      const ClosestPoint hit = tree.first_hit(origin, direction);
      const double expected = brute_hit(mesh, origin, direction);
      QCOMPARE(hit.triangle >= 0, std::isfinite(expected));
      if (hit.triangle < 0) continue;
      ++hits;
      QVERIFY(std::abs(hit.distance - expected) < 1e-9);
      QVERIFY((hit.point - origin - hit.distance * direction).norm() < 1e-12);
    }
    QVERIFY(hits > 20);
  }
}

void ClosestPointTreeTest::RayAlongAnAxisInTheBoxPlaneHits() {
  // The ray lies in the plane of one face of every bounding box.
  const ClosestPointTree tree(test::box({0.1, 0.1, 0.1}));
  QVERIFY(tree.first_hit({0.01, 0.02, -1.0}, {0, 0, 1}).triangle >= 0);
  QVERIFY(std::abs(tree.first_hit({0.01, 0.02, -1.0}, {0, 0, 1}).distance - 0.95) < 1e-12);
}

void ClosestPointTreeTest::RayParametersBoundTheHit() {
  const ClosestPointTree tree(test::sphere(0.06, 3));
  const Eigen::Vector3d origin(-0.2, 0.001, 0.002), along(2, 0, 0);
  const ClosestPoint first = tree.first_hit(origin, along);
  QVERIFY(std::abs(first.distance - 0.07) < 1e-3);  // in units of the direction
  QVERIFY(std::abs(tree.first_hit(origin, along, first.distance).distance - 0.13) < 1e-3);
  QCOMPARE(tree.first_hit(origin, along, 0.0, 0.06).triangle, -1);
}

void ClosestPointTreeTest::EmptyMeshFindsNothing() {
  const ClosestPointTree tree((TriangleMesh()));
  QVERIFY(tree.empty());
  QCOMPARE(tree.closest({0, 0, 0}).triangle, -1);
  QCOMPARE(tree.first_hit({0, 0, 0}, {0, 0, 1}).triangle, -1);
}

void ClosestPointTreeTest::DegenerateTriangleIsNoTrap() {
  const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0);
  for (const auto& weights :
       {closest_on_triangle({0.5, 1, 0}, a, b, 0.5 * (a + b)), closest_on_triangle({2, 1, 0}, a, a, a)})
    QVERIFY(weights.allFinite() && std::abs(weights.sum() - 1.0) < 1e-12);
}

void ClosestPointTreeTest::ATriangleThatIsALineIsItsEdges() {
  // As STL files have them: the third corner on the line of the others, as far as doubles can be.
  std::uniform_real_distribution<double> place(-0.5, 1.5);
  const auto from_edge = [](const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double along = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (p - a - along * (b - a)).norm();
  };
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d a = random_point(0.1), b = random_point(0.1), c = a + place(generator) * (b - a),
                          p = random_point(0.2);
    const Eigen::Vector3d weights = closest_on_triangle(p, a, b, c);
    const double distance = (weights[0] * a + weights[1] * b + weights[2] * c - p).norm();
    const double truth = std::min({from_edge(p, a, b), from_edge(p, b, c), from_edge(p, c, a)});
    QVERIFY2(std::abs(distance - truth) < 1e-9,
             qPrintable(QString::number(1e3 * (distance - truth)) + " mm"));
    QVERIFY(weights.minCoeff() >= 0.0 && std::abs(weights.sum() - 1.0) < 1e-12);
  }
}

void ClosestPointTreeTest::RefitWithOtherVerticesIsRefused() {
  ClosestPointTree tree(test::sphere(0.06, 1));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, tree.refit(Points::Zero(3, 3)));
}

QTEST_APPLESS_MAIN(ClosestPointTreeTest)
#include "closest_point_tree_test.moc"
