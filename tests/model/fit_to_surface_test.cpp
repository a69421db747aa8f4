// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_to_surface.h"

#include <QTest>
#include <random>

#include "fill_dents.h"
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
  void NodesThatCellsHoldBackGetRoom();
  void SliversOfTheMesherAreMended_data();
  void SliversOfTheMesherAreMended();
  void ADentIsFilledByWhatWasTakenOut();
  void AGrooveOfTheBodyIsNotFilled();
  void CancelStopsTheFitAtTheNextNode();
  void CancelStopsTheFillingOfDents();
  void MeshWithoutASurfaceIsRefused();

 private:
  /// The ball without one cell that has a face on its boundary and a node inside.
  TetMesh dented() const;
  TetMesh mesh_;
};

void FitToSurfaceTest::NodesThatStrayedComeBack() {
  TetMesh mesh = mesh_;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> off(-2e-3, 2e-3);
  for (const int node : boundary_surface(mesh).node_of_vertex)
    for (int k = 0; k < 3; ++k) mesh.vertices(node, k) += off(random);
  QVERIFY(mean_off(mesh) > 0.7e-3);
  model::fit_to_surface(mesh, {&kBall, volume(kBall), {}}, 10.0, RunContext());
  QVERIFY2(mean_off(mesh) < 0.25e-3, qPrintable(QString::number(1e3 * mean_off(mesh))));
  check_tetrahedra(mesh, "mesh");
}

void FitToSurfaceTest::NoAngleGetsWorseThanAllowed() {
  TetMesh mesh = mesh_;
  const double before = dihedral_angles(mesh).col(0).minCoeff();
  for (const int node : boundary_surface(mesh).node_of_vertex) mesh.vertices.row(node) *= 0.97;
  const double squeezed = dihedral_angles(mesh).col(0).minCoeff();
  model::fit_to_surface(mesh, {&kBall, volume(kBall), {}}, 10.0, RunContext());
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
  model::fit_to_surface(mesh, {&kBall, 0.9 * volume(mesh_), {}}, 10.0, RunContext());
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
  model::fit_to_surface(mesh, {&kBall, volume(kBall), {{16, wanted}}}, 10.0, RunContext());
  QVERIFY2(std::abs(volume_of(mesh, 16) / wanted - 1.0) < 0.02,
           qPrintable(QString::number(volume_of(mesh, 16) / wanted)));
  check_tetrahedra(mesh, "mesh");
}

void FitToSurfaceTest::FarMovesStopBeforeACellTurnsOver() {
  TetMesh mesh = mesh_;
  const TriangleMesh small = test::sphere(0.03, 3);  // half as large: no mesh of this topology fits it well
  model::fit_to_surface(mesh, {&small, volume(small), {}}, 10.0, RunContext());
  check_tetrahedra(mesh, "mesh");
  QVERIFY(dihedral_angles(mesh).col(0).minCoeff() >= 10.0 - 1e-9);
}

void FitToSurfaceTest::NodesThatCellsHoldBackGetRoom() {
  // A fifth of the boundary 8 mm inside, and inner nodes beside their places: some straight ways out would
  // flatten cells (without room one node stays 1 mm inside).
  TetMesh mesh = mesh_;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> off(-8e-3, 8e-3);
  std::vector<char> boundary(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (const int node : boundary_surface(mesh).node_of_vertex) boundary[static_cast<std::size_t>(node)] = 1;
  for (int node = 0; node < mesh.vertex_count(); ++node) {
    const Eigen::RowVector3d before = mesh.vertices.row(node);
    if (boundary[static_cast<std::size_t>(node)]) {
      if (node % 5 == 0) mesh.vertices.row(node) -= 8e-3 * before.normalized();
    } else {
      for (int k = 0; k < 3; ++k) mesh.vertices(node, k) += off(random);
    }
    if (tetrahedron_volumes(mesh).minCoeff() <= 0.0) mesh.vertices.row(node) = before;
  }
  model::fit_to_surface(mesh, {&kBall, volume(kBall), {}}, 10.0, RunContext());
  check_tetrahedra(mesh, "mesh");
  const auto off_ball = summarise(distances_to_surface(boundary_surface(mesh).mesh.vertices, kBall));
  QVERIFY2(off_ball.maximum < 0.16e-3, qPrintable(QString::number(1e3 * off_ball.maximum)));
}

TetMesh FitToSurfaceTest::dented() const {
  std::vector<char> boundary(static_cast<std::size_t>(mesh_.vertex_count()), 0);
  for (const int node : boundary_surface(mesh_).node_of_vertex) boundary[static_cast<std::size_t>(node)] = 1;
  TetMesh mesh = mesh_;
  for (int t = 0; t < mesh_.tetrahedron_count(); ++t) {
    int on = 0;
    for (int k = 0; k < 4; ++k) on += boundary[static_cast<std::size_t>(mesh_.tetrahedra(t, k))];
    if (on != 3) continue;
    const Eigen::Index last = mesh.tetrahedra.rows() - 1;
    mesh.tetrahedra.row(t) = mesh_.tetrahedra.row(last);
    mesh.tetrahedra.conservativeResize(last, 4);
    mesh.labels.pop_back();
    if (boundary_surface(mesh).mesh.triangle_count() == boundary_surface(mesh_).mesh.triangle_count() + 2)
      return mesh;  // one face less, three more
    mesh = mesh_;
  }
  return mesh;
}

void FitToSurfaceTest::SliversOfTheMesherAreMended_data() {
  QTest::addColumn<bool>("inside");
  QTest::newRow("a node inside") << true;
  QTest::newRow("a node of the boundary") << false;
}

void FitToSurfaceTest::SliversOfTheMesherAreMended() {
  QFETCH(bool, inside);
  TetMesh mesh = mesh_;
  model::fit_to_surface(mesh, {&kBall, volume(kBall), {}}, 10.0, RunContext());
  const std::vector<int> skin = boundary_surface(mesh).node_of_vertex;
  // Pressed towards the opposite face of one of its cells until that is nearly flat.
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
    const int node = mesh.tetrahedra(t, 0);
    if ((std::find(skin.begin(), skin.end(), node) == skin.end()) != inside) continue;
    const Eigen::RowVector3d face = (mesh.vertex(mesh.tetrahedra(t, 1)) + mesh.vertex(mesh.tetrahedra(t, 2)) +
                                     mesh.vertex(mesh.tetrahedra(t, 3)))
                                        .transpose() /
                                    3.0;
    mesh.vertices.row(node) += 0.93 * (face - mesh.vertices.row(node));
    break;
  }
  QVERIFY(dihedral_angles(mesh).col(0).minCoeff() < 6.0);
  model::fit_to_surface(mesh, {&kBall, volume(kBall), {}}, 10.0, RunContext());
  const double least = dihedral_angles(mesh).col(0).minCoeff();
  QVERIFY2(least >= 10.0, qPrintable(QString::number(least)));
  QVERIFY2(mean_off(mesh) < 0.25e-3, qPrintable(QString::number(1e3 * mean_off(mesh))));
}

void FitToSurfaceTest::ADentIsFilledByWhatWasTakenOut() {
  TetMesh mesh = dented();
  QCOMPARE(mesh.tetrahedron_count(), mesh_.tetrahedron_count() - 1);
  const ClosestPointTree tree(kBall);
  const Points normals = triangle_normals(kBall);
  QCOMPARE(model::fill_dents(mesh, tree, normals, 7, 10.0, RunContext()), 1);
  QCOMPARE(mesh.tetrahedron_count(), mesh_.tetrahedron_count());
  QCOMPARE(mesh.labels.back(), 7);
  check_tetrahedra(mesh, "mesh");
  QVERIFY(is_closed(boundary_surface(mesh).mesh));
  QVERIFY(std::abs(volume(mesh) - volume(mesh_)) < 1e-12);
  // A whole mesh has none; and a cell with such an angle is not put in.
  QCOMPARE(model::fill_dents(mesh, tree, normals, 7, 10.0, RunContext()), 0);
  mesh = dented();
  QCOMPARE(model::fill_dents(mesh, tree, normals, 7, 80.0, RunContext()), 0);
}

void FitToSurfaceTest::AGrooveOfTheBodyIsNotFilled() {
  TetMesh mesh = dented();
  const TriangleMesh body = boundary_surface(mesh).mesh;
  QCOMPARE(model::fill_dents(mesh, ClosestPointTree(body), triangle_normals(body), 1, 10.0, RunContext()), 0);
}

void FitToSurfaceTest::CancelStopsTheFitAtTheNextNode() {
  auto flag = std::make_shared<CancelFlag>();
  const RunContext context([](double, std::string_view) {}, flag, 1);
  TetMesh mesh = mesh_;
  for (const int node : boundary_surface(mesh).node_of_vertex) mesh.vertices.row(node) *= 0.97;
  const TetMesh before = mesh;
  flag->request();
  QVERIFY(!model::fit_to_surface(mesh, {&kBall, volume(kBall), {}}, 10.0, context));
  QVERIFY(mesh.vertices == before.vertices);
  QVERIFY(model::fit_to_surface(mesh, {&kBall, volume(kBall), {}}, 10.0, RunContext()));
  QVERIFY(mesh.vertices != before.vertices);
}

void FitToSurfaceTest::CancelStopsTheFillingOfDents() {
  auto flag = std::make_shared<CancelFlag>();
  const RunContext context([](double, std::string_view) {}, flag, 1);
  flag->request();
  TetMesh mesh = dented();
  const int cells = mesh.tetrahedron_count();
  QCOMPARE(model::fill_dents(mesh, ClosestPointTree(kBall), triangle_normals(kBall), 7, 10.0, context), 0);
  QCOMPARE(mesh.tetrahedron_count(), cells);
}

void FitToSurfaceTest::MeshWithoutASurfaceIsRefused() {
  TetMesh mesh = mesh_;
  QVERIFY_THROWS_EXCEPTION(PreconditionError,
                           model::fit_to_surface(mesh, {nullptr, 1.0, {}}, 10.0, RunContext()));
  QVERIFY_THROWS_EXCEPTION(PreconditionError,
                           model::fit_to_surface(mesh, {&kBall, 0.0, {}}, 10.0, RunContext()));
}

QTEST_APPLESS_MAIN(FitToSurfaceTest)
#include "fit_to_surface_test.moc"
