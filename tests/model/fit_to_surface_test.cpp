// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_to_surface.h"

#include <QtTest>
#include <random>

#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/topology.h"
#include "glisson/model/build.h"
#include "shapes.h"

using namespace glisson;

namespace {

const TriangleMesh kBall = test::sphere(0.06, 4);

TetMesh filled_ball() {
  model::MeshOptions options;
  options.target_vertices = 300;
  return *model::mesh_surface(kBall, options, RunContext());
}

double mean_off(const TetMesh& mesh) {
  return summarise(distances_to_surface(boundary_surface(mesh).mesh.vertices, kBall)).mean;
}

double volume_of(const TetMesh& mesh, int label) {
  double sum = 0.0;
  const Eigen::VectorXd volumes = tetrahedron_volumes(mesh);
  for (int t = 0; t < mesh.tetrahedron_count(); ++t)
    if (mesh.labels[static_cast<std::size_t>(t)] == label) sum += volumes[t];
  return sum;
}

}  // namespace

class FitToSurfaceTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() { mesh_ = filled_ball(); }
  void NodesThatStrayedComeBack();
  void NoAngleGetsWorseThanAllowed();
  void VolumeIsMadeUpForWithinTheOffset();
  void SubdomainGetsItsVolume();
  void FarMovesStopBeforeACellTurnsOver();
  void MeshWithoutASurfaceIsRefused();

 private:
  TetMesh mesh_;
};

void FitToSurfaceTest::NodesThatStrayedComeBack() {
  TetMesh mesh = mesh_;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> off(-2e-3, 2e-3);
  for (const int node : boundary_surface(mesh).node_of_vertex)
    for (int k = 0; k < 3; ++k) mesh.vertices(node, k) += off(random);
  QVERIFY(mean_off(mesh) > 0.7e-3);
  model::fit_to_surface(mesh, {&kBall, volume(kBall), {}}, 10.0);
  QVERIFY2(mean_off(mesh) < 0.25e-3, qPrintable(QString::number(1e3 * mean_off(mesh))));
  check_tetrahedra(mesh, "mesh");
}

void FitToSurfaceTest::NoAngleGetsWorseThanAllowed() {
  TetMesh mesh = mesh_;
  const double before = dihedral_angles(mesh).col(0).minCoeff();
  for (const int node : boundary_surface(mesh).node_of_vertex) mesh.vertices.row(node) *= 0.97;
  const double squeezed = dihedral_angles(mesh).col(0).minCoeff();
  model::fit_to_surface(mesh, {&kBall, volume(kBall), {}}, 10.0);
  QVERIFY(dihedral_angles(mesh).col(0).minCoeff() >= std::min({10.0, before, squeezed}) - 1e-9);
}

void FitToSurfaceTest::VolumeIsMadeUpForWithinTheOffset() {
  const BoundarySurface boundary = boundary_surface(mesh_);
  double standing_out = 0.0;
  for (int v = 0; v < boundary.mesh.vertex_count(); ++v) {
    QVERIFY(boundary.mesh.vertex(v).norm() < 0.06 + 0.16e-3);
    standing_out += boundary.mesh.vertex(v).norm() - 0.06;
  }
  // A polyhedron of 300 nodes in the ball misses far more than 0.15 mm all around: all of it is taken.
  QVERIFY(standing_out / boundary.mesh.vertex_count() > 0.1e-3);
  // A volume that is already there asks for nothing.
  TetMesh mesh = mesh_;
  model::fit_to_surface(mesh, {&kBall, 0.9 * volume(mesh_), {}}, 10.0);
  QVERIFY(volume(mesh) < volume(mesh_));
}

void FitToSurfaceTest::SubdomainGetsItsVolume() {
  TetMesh mesh = mesh_;
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int k = 0; k < 4; ++k) middle += 0.25 * mesh.vertex(mesh.tetrahedra(t, k));
    mesh.labels[static_cast<std::size_t>(t)] = middle.norm() < 0.025 ? 16 : 1;
  }
  const double wanted = 1.08 * volume_of(mesh, 16);
  model::fit_to_surface(mesh, {&kBall, volume(kBall), {{16, wanted}}}, 10.0);
  QVERIFY2(std::abs(volume_of(mesh, 16) / wanted - 1.0) < 0.02,
           qPrintable(QString::number(volume_of(mesh, 16) / wanted)));
  check_tetrahedra(mesh, "mesh");
}

void FitToSurfaceTest::FarMovesStopBeforeACellTurnsOver() {
  TetMesh mesh = mesh_;
  const TriangleMesh small = test::sphere(0.03, 3);  // half as large: no mesh of this topology fits it well
  model::fit_to_surface(mesh, {&small, volume(small), {}}, 10.0);
  check_tetrahedra(mesh, "mesh");
  QVERIFY(dihedral_angles(mesh).col(0).minCoeff() >= 10.0 - 1e-9);
}

void FitToSurfaceTest::MeshWithoutASurfaceIsRefused() {
  TetMesh mesh = mesh_;
  QVERIFY_EXCEPTION_THROWN(model::fit_to_surface(mesh, {nullptr, 1.0, {}}, 10.0), PreconditionError);
  QVERIFY_EXCEPTION_THROWN(model::fit_to_surface(mesh, {&kBall, 0.0, {}}, 10.0), PreconditionError);
}

QTEST_APPLESS_MAIN(FitToSurfaceTest)
#include "fit_to_surface_test.moc"
