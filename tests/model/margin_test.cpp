// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <numbers>

#include "data_folder.h"
#include "glisson/core/run_context.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/model/build.h"
#include "shapes.h"

using namespace glisson;

namespace {

/// A loaf along x whose cross-section is a drop: one sharp edge, at v = 0 (the margin), round elsewhere.
/// @param from the margin's ends, mm along x. @param round how far the sharp edge is blunted.
TriangleMesh loaf(int along, int across) {
  TriangleMesh mesh;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= along; ++i) {
    const double s = static_cast<double>(i) / along, x = -0.09 + 0.18 * s;
    const double taper = std::sqrt(std::max(1e-4, 1.0 - std::pow(2.0 * s - 1.0, 4)));
    for (int j = 0; j < across; ++j) {
      const double v = 2.0 * std::numbers::pi * j / across;
      // Sharp where v = 0: the cross-section's tangent turns there by 106 degrees at once.
      const double y = 0.05 * std::cos(v), z = 0.04 * std::sin(v) * std::abs(std::sin(0.5 * v));
      points.emplace_back(x, taper * y, taper * z);
    }
  }
  const int first = static_cast<int>(points.size());
  points.emplace_back(-0.0905, 0, 0);
  points.emplace_back(0.0905, 0, 0);
  std::vector<Eigen::Vector3i> triangles;
  for (int j = 0; j < across; ++j) {
    const int next = (j + 1) % across;
    for (int i = 0; i < along; ++i) {
      const int a = i * across + j, b = (i + 1) * across + j, c = (i + 1) * across + next,
                d = i * across + next;
      triangles.emplace_back(a, d, c);
      triangles.emplace_back(a, c, b);
    }
    triangles.emplace_back(first, next, j);
    triangles.emplace_back(first + 1, along * across + j, along * across + next);
  }
  mesh.vertices.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    mesh.vertices.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    mesh.triangles.row(static_cast<Eigen::Index>(t)) = triangles[t].transpose();
  if (volume(mesh) < 0.0) mesh.triangles.col(1).swap(mesh.triangles.col(2));
  return mesh;
}

/// The margin of the loaf, by formula.
double from_true_margin(const Eigen::Vector3d& p) {
  double least = 1.0;
  for (int i = 0; i <= 1000; ++i) {
    const double s = i / 1000.0;
    const double taper = std::sqrt(std::max(1e-4, 1.0 - std::pow(2.0 * s - 1.0, 4)));
    least = std::min(least, (p - Eigen::Vector3d(-0.09 + 0.18 * s, taper * 0.05, 0.0)).norm());
  }
  return least;
}

double length_of(const Points& line) {
  double sum = 0.0;
  for (Eigen::Index i = 1; i < line.rows(); ++i) sum += (line.row(i) - line.row(i - 1)).norm();
  return sum;
}

double mean_distance(const Points& from, const Points& to) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < from.rows(); ++i)
    sum += (to.rowwise() - from.row(i)).rowwise().norm().minCoeff();
  return sum / static_cast<double>(from.rows());
}

const Eigen::Vector3d kAny = Eigen::Vector3d::Zero();

}  // namespace

class MarginTest : public QObject {
  Q_OBJECT
 private slots:
  void SharpEdgeIsFound();
  void LineIsOrderedAndEven();
  void RigidMotionMovesTheLineAlong();
  void RemeshingLeavesTheLine();
  void TetrahedralBoundaryGivesTheSameLine();
  void SphereHasNoMargin();
  void TorusHasNoMargin();
  void DirectionChoosesTheRidge();
  void HollowCreaseIsNoMargin();
  void EmptyMeshHasNoMargin();
  void RealLiverKeepsItsMarginUnderRemeshing();
};

void MarginTest::SharpEdgeIsFound() {
  const Points line = model::detect_anterior_margin(loaf(60, 48), kAny);
  QVERIFY(line.rows() > 20);
  double worst = 0.0, sum = 0.0;
  for (Eigen::Index i = 0; i < line.rows(); ++i) {
    const double miss = from_true_margin(line.row(i).transpose());
    worst = std::max(worst, miss);
    sum += miss;
  }
  QVERIFY2(sum / static_cast<double>(line.rows()) < 2e-3,
           qPrintable(QString::number(1e3 * sum / static_cast<double>(line.rows()))));
  QVERIFY2(line.col(0).maxCoeff() - line.col(0).minCoeff() > 0.14,
           qPrintable(QString::number(line.col(0).maxCoeff())));
}

void MarginTest::LineIsOrderedAndEven() {
  const Points line = model::detect_anterior_margin(loaf(60, 48), kAny);
  for (Eigen::Index i = 1; i < line.rows(); ++i) {
    const double step = (line.row(i) - line.row(i - 1)).norm();
    QVERIFY(step > 1e-3 && step < 6e-3);
  }
  // Ordered: the chord from end to end is not much shorter than the line, which never turns back.
  QVERIFY((line.row(0) - line.row(line.rows() - 1)).norm() > 0.6 * length_of(line));
}

void MarginTest::RigidMotionMovesTheLineAlong() {
  const TriangleMesh mesh = loaf(50, 40);
  const Points line = model::detect_anterior_margin(mesh, Eigen::Vector3d(0.0, 1.0, 0.2));
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.7).normalized()).toRotationMatrix();
  TriangleMesh moved = mesh;
  moved.vertices = (mesh.vertices * turn.transpose()).rowwise() + Eigen::RowVector3d(0.3, -1.0, 0.2);
  const Points expected = (line * turn.transpose()).rowwise() + Eigen::RowVector3d(0.3, -1.0, 0.2);
  const Points found = model::detect_anterior_margin(moved, turn * Eigen::Vector3d(0.0, 1.0, 0.2));
  QCOMPARE(found.rows(), expected.rows());
  QVERIFY((found - expected).rowwise().norm().maxCoeff() < 1e-6);
}

void MarginTest::RemeshingLeavesTheLine() {
  const Points coarse = model::detect_anterior_margin(loaf(30, 24), kAny),
               fine = model::detect_anterior_margin(loaf(110, 96), kAny);
  QVERIFY2(mean_distance(coarse, fine) < 3e-3,
           qPrintable(QString::number(1e3 * mean_distance(coarse, fine))));
  QVERIFY2(mean_distance(fine, coarse) < 3e-3,
           qPrintable(QString::number(1e3 * mean_distance(fine, coarse))));
}

void MarginTest::TetrahedralBoundaryGivesTheSameLine() {
  const TriangleMesh mesh = loaf(60, 48);
  model::MeshOptions options;
  options.target_vertices = 600;
  const auto volume_mesh = model::mesh_surface(mesh, options, RunContext());
  const Points line = model::detect_anterior_margin(boundary_surface(*volume_mesh).mesh, kAny);
  QVERIFY(line.rows() > 15);
  double sum = 0.0;
  for (Eigen::Index i = 0; i < line.rows(); ++i) sum += from_true_margin(line.row(i).transpose());
  QVERIFY2(sum / static_cast<double>(line.rows()) < 5e-3,
           qPrintable(QString::number(1e3 * sum / static_cast<double>(line.rows()))));
}

void MarginTest::SphereHasNoMargin() {
  QCOMPARE(model::detect_anterior_margin(test::sphere(0.07, 4), kAny).rows(), 0L);
}

void MarginTest::TorusHasNoMargin() {
  QCOMPARE(model::detect_anterior_margin(test::torus(0.08, 0.035, 80, 40), kAny).rows(), 0L);
}

void MarginTest::DirectionChoosesTheRidge() {
  // A wedge: one long edge on either side.
  const TriangleMesh plate = test::box({0.2, 0.12, 0.03});
  for (const double side : {-1.0, 1.0}) {
    const Points line = model::detect_anterior_margin(plate, Eigen::Vector3d(0.0, side, 0.0));
    QVERIFY(line.rows() > 20);
    QVERIFY(side * line.col(1).mean() > 0.04);
  }
}

void MarginTest::HollowCreaseIsNoMargin() {
  // The same drop turned inside out: its edge is a groove.
  TriangleMesh mesh = loaf(50, 40);
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  QCOMPARE(model::detect_anterior_margin(mesh, kAny).rows(), 0L);
}

void MarginTest::EmptyMeshHasNoMargin() { QCOMPARE(model::detect_anterior_margin({}, kAny).rows(), 0L); }

void MarginTest::RealLiverKeepsItsMarginUnderRemeshing() {
  const std::filesystem::path path = test::data_folder() / "liver_models" / "liver.vtk";
  if (!std::filesystem::exists(path)) QSKIP("liver_models is not here (set GLISSON_DATA)");
  const TriangleMesh liver = split_components(read_triangle_mesh(path, LengthUnit::millimetre)).front();
  model::MeshOptions options;
  options.target_vertices = 3000;
  const TriangleMesh remeshed = boundary_surface(*model::mesh_surface(liver, options, RunContext())).mesh;
  const Eigen::Vector3d inferior_anterior(0.0, -1.0, -1.0);
  const Points before = model::detect_anterior_margin(liver, inferior_anterior),
               after = model::detect_anterior_margin(remeshed, inferior_anterior);
  qInfo("margin %.0f mm, remeshed %.0f mm, apart by %.1f and %.1f mm", 1e3 * length_of(before),
        1e3 * length_of(after), 1e3 * mean_distance(before, after), 1e3 * mean_distance(after, before));
  QVERIFY(mean_distance(after, before) < 8e-3);
  QVERIFY(mean_distance(before, after) < 15e-3);
}

QTEST_APPLESS_MAIN(MarginTest)
#include "margin_test.moc"
