// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/patient_model.h"

#include <QTest>

#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"

using namespace glisson;

namespace {

/// A block of n^3 cubes of the given side, each cut into six tetrahedra around its main diagonal (Kuhn).
TetMesh block(int n, double side) {
  TetMesh mesh;
  const auto node = [n](int x, int y, int z) { return x + (n + 1) * (y + (n + 1) * z); };
  mesh.vertices.resize((n + 1) * (n + 1) * (n + 1), 3);
  for (int z = 0; z <= n; ++z)
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x) mesh.vertices.row(node(x, y, z)) << side * x, side * y, side * z;
  mesh.tetrahedra.resize(6 * n * n * n, 4);
  int t = 0;
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        std::array<int, 3> axes = {0, 1, 2};
        do {
          Eigen::Vector3i p(x, y, z);
          mesh.tetrahedra(t, 0) = node(p.x(), p.y(), p.z());
          for (std::size_t k = 0; k < 3; ++k) {
            ++p[axes[k]];
            mesh.tetrahedra(t, static_cast<Eigen::Index>(k) + 1) = node(p.x(), p.y(), p.z());
          }
          ++t;
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  orient_tetrahedra(mesh);
  return mesh;
}

Points random_points(int n, double low, double high) {
  std::mt19937 random(3);  // NOLINT: the same points on every run
  std::uniform_real_distribution<double> uniform(low, high);
  Points points(n, 3);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 3; ++k) points(i, k) = uniform(random);
  return points;
}

}  // namespace

class PatientModelTest : public QObject {
  Q_OBJECT

 private slots:
  void BoundPointsAreWhereTheyWere() {
    const TetMesh mesh = block(4, 0.02);
    const Points points = random_points(500, 0.0, 0.08);
    const Binding binding = bind_points(mesh, points);
    QVERIFY(binding.outside.empty());
    QVERIFY(binding.weights.minCoeff() > -1e-8);
    QVERIFY((binding.weights.rowwise().sum().array() - 1.0).abs().maxCoeff() < 1e-12);
    QVERIFY((binding.apply(mesh, mesh.vertices) - points).cwiseAbs().maxCoeff() < 1e-12);
  }

  void BoundPointsFollowAnAffineMotionExactly() {
    const TetMesh mesh = block(3, 0.03);
    const Points points = random_points(200, 0.0, 0.09);
    Eigen::Matrix3d a;
    a << 1.1, 0.2, 0.0, -0.1, 0.9, 0.3, 0.05, 0.0, 1.2;
    const Eigen::RowVector3d b(0.1, -0.2, 0.3);
    const Points moved = (mesh.vertices * a.transpose()).rowwise() + b;
    const Points expected = (points * a.transpose()).rowwise() + b;
    QVERIFY((bind_points(mesh, points).apply(mesh, moved) - expected).cwiseAbs().maxCoeff() < 1e-12);
  }

  void PointsOutsideAreReportedAndClampedToTheSurface() {
    const TetMesh mesh = block(2, 0.05);
    Points points(3, 3);
    points << 0.05, 0.05, 0.05, 0.13, 0.04, 0.03, -0.02, -0.02, -0.02;
    const Binding binding = bind_points(mesh, points);
    QVERIFY((binding.outside == std::vector<int>{1, 2}));
    const Points placed = binding.apply(mesh, mesh.vertices);
    QVERIFY((placed.row(1) - Eigen::RowVector3d(0.1, 0.04, 0.03)).norm() < 1e-12);
    QVERIFY(placed.row(2).norm() < 1e-12);
  }

  void PointsOutsideExtrapolateWhenNotClamped() {
    const TetMesh mesh = block(2, 0.05);
    Points points(1, 3);
    points << 0.13, 0.04, 0.03;
    const Binding binding = bind_points(mesh, points, false);
    QCOMPARE(binding.outside.size(), std::size_t{1});
    QVERIFY((binding.apply(mesh, mesh.vertices) - points).cwiseAbs().maxCoeff() < 1e-12);
  }

  void FarPointsDoNotBreakTheLookup() {
    const TetMesh mesh = block(2, 0.05);
    Points points(2, 3);
    points << 1e9, 0.05, 0.05, -1e9, 0.05, 0.05;
    const Points placed = bind_points(mesh, points).apply(mesh, mesh.vertices);
    QVERIFY(std::abs(placed(0, 0) - 0.1) < 1e-6 && std::abs(placed(1, 0)) < 1e-6);
  }

  void BindingRefusesAnEmptyMeshAndForeignNodes() {
    QVERIFY_THROWS_EXCEPTION(PreconditionError, bind_points(TetMesh{}, Points::Zero(1, 3)));
    const TetMesh mesh = block(1, 0.05);
    const Binding binding = bind_points(mesh, Points::Constant(1, 3, 0.01));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, binding.apply(mesh, Points::Zero(3, 3)));
  }

  void LesionCentreIsTheCentroidOfItsTetrahedra() {
    PatientModel model;
    model.mesh = block(4, 0.01);
    model.mesh.labels.assign(static_cast<std::size_t>(model.mesh.tetrahedron_count()),
                             structure::kParenchyma);
    // Cube (2, 1, 3) and, unequal in volume, half of the cube beside it.
    const int cube = 2 + 4 * (1 + 4 * 3);
    for (int t = 6 * cube; t < 6 * cube + 6; ++t)
      model.mesh.labels[static_cast<std::size_t>(t)] = structure::kFirstLesion;
    const auto centres = lesion_centres(model);
    QCOMPARE(centres.size(), std::size_t{1});
    QCOMPARE(static_cast<int>(centres[0].first), static_cast<int>(structure::kFirstLesion));
    QVERIFY((centres[0].second - Eigen::Vector3d(0.025, 0.015, 0.035)).norm() < 1e-12);
  }

  void ALabelThatSixteenBitsWouldCutIsNoLesion() {
    PatientModel model;
    model.mesh = block(1, 0.01);
    model.mesh.labels.assign(6, 65536 + structure::kFirstLesion);
    QVERIFY(lesion_centres(model).empty());
  }

  void LesionCentreWeighsByVolume() {
    PatientModel model;
    model.mesh.vertices.resize(8, 3);
    model.mesh.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 10, 0, 0, 12, 0, 0, 10, 2, 0, 10, 0, 2;
    model.mesh.tetrahedra.resize(2, 4);
    model.mesh.tetrahedra << 0, 1, 2, 3, 4, 5, 6, 7;
    model.mesh.labels = {structure::kFirstLesion, structure::kFirstLesion};
    const Eigen::Vector3d small(0.25, 0.25, 0.25), large(10.5, 0.5, 0.5);
    QVERIFY((lesion_centres(model)[0].second - (small + 8.0 * large) / 9.0).norm() < 1e-12);
  }

  void LesionWithoutTetrahedraTakesItsSurface() {
    PatientModel model;
    model.mesh = block(1, 0.01);
    model.mesh.labels.assign(6, structure::kParenchyma);
    const Label label = structure::kFirstLesion + 1;
    NamedSurface lesion{label, "lesion_2", boundary_surface(block(2, 0.002)).mesh};
    lesion.mesh.vertices.rowwise() += Eigen::RowVector3d(0.003, 0.004, 0.005);
    model.surfaces.push_back(lesion);
    const auto centres = lesion_centres(model);
    QCOMPARE(centres.size(), std::size_t{1});
    QCOMPARE(static_cast<int>(centres[0].first), static_cast<int>(label));
    QVERIFY((centres[0].second - Eigen::Vector3d(0.005, 0.006, 0.007)).norm() < 1e-12);
  }
};

QTEST_APPLESS_MAIN(PatientModelTest)
#include "patient_model_test.moc"
