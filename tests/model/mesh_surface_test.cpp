// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "data_folder.h"
#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/topology.h"
#include "glisson/model/build.h"
#include "shapes.h"

using namespace glisson;

namespace {

model::MeshOptions with_vertices(int count) {
  model::MeshOptions options;
  options.target_vertices = count;
  return options;
}

/// What every mesh must keep to, whatever it fills.
void require_good(const TetMesh& mesh, const TriangleMesh& surface, int wanted, double volume_tolerance) {
  check_tetrahedra(mesh, "mesh");
  QVERIFY2(std::abs(mesh.vertex_count() - wanted) <= 0.1 * wanted,
           qPrintable(QString::number(mesh.vertex_count())));
  QVERIFY(dihedral_angles(mesh).col(0).minCoeff() >= 10.0);
  const BoundarySurface boundary = boundary_surface(mesh);
  QVERIFY(is_closed(boundary.mesh));
  int pieces = 0;
  connected_components(boundary.mesh, &pieces);
  QCOMPARE(pieces, 1);
  QVERIFY2(std::abs(volume(mesh) / volume(surface) - 1.0) < volume_tolerance,
           qPrintable(QString::number(volume(mesh) / volume(surface))));
  // Boundary nodes stand out by 0.15 mm at most, and the few that the angles hold back lie a little off.
  QVERIFY(summarise(distances_to_surface(boundary.mesh.vertices, surface)).mean <= 0.25e-3);
}

int euler_characteristic(const TriangleMesh& mesh) {
  return mesh.vertex_count() - static_cast<int>(edges(mesh).size()) + mesh.triangle_count();
}

}  // namespace

class MeshSurfaceTest : public QObject {
  Q_OBJECT
 private slots:
  void SphereIsFilled_data();
  void SphereIsFilled();
  void EdgesAreAsLongAsAsked_data();
  void EdgesAreAsLongAsAsked();
  void TooShortEdgesAreRefused();
  void TorusKeepsItsHole();
  void BoxWithSharpEdgesIsFilled();
  void ThinPlateHasAManifoldBoundary();
  void SameInputGivesTheSameBits();
  void InwardNormalsGiveTheSameMesh();
  void SpecksAreDropped();
  void SeveralLargePiecesAreRefused();
  void OpenSurfaceIsRefused();
  void NotANumberIsRefused();
  void EmptySurfaceIsRefused();
  void OptionsOutOfRangeAreRefused();
  void CancelGivesNothing();
  void ProgressNeverGoesBack();
  void RealLiverMeetsThePaper();
};

void MeshSurfaceTest::SphereIsFilled_data() {
  QTest::addColumn<int>("vertices");
  QTest::newRow("coarse") << 150;
  QTest::newRow("fine") << 1200;
}

void MeshSurfaceTest::SphereIsFilled() {
  QFETCH(int, vertices);
  const TriangleMesh surface = test::sphere(0.06, 4);
  const auto mesh = model::mesh_surface(surface, with_vertices(vertices), RunContext());
  QVERIFY(mesh.has_value());
  require_good(*mesh, surface, vertices, vertices < 500 ? 0.08 : 0.02);
}

void MeshSurfaceTest::EdgesAreAsLongAsAsked_data() {
  QTest::addColumn<double>("edge_mm");
  for (const double edge : {22.0, 12.0}) QTest::newRow(qPrintable(QString::number(edge))) << edge;
}

void MeshSurfaceTest::EdgesAreAsLongAsAsked() {
  QFETCH(double, edge_mm);
  model::MeshOptions options;
  options.edge_mm = edge_mm;
  const auto mesh = model::mesh_surface(test::sphere(0.06, 4), options, RunContext());
  double sum = 0.0;
  for (int t = 0; t < mesh->tetrahedron_count(); ++t)
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b)
        sum += (mesh->vertex(mesh->tetrahedra(t, a)) - mesh->vertex(mesh->tetrahedra(t, b))).norm();
  const double mean = 1e3 * sum / (6.0 * mesh->tetrahedron_count());
  QVERIFY2(std::abs(mean / edge_mm - 1.0) < 0.15, qPrintable(QString::number(mean)));
}

void MeshSurfaceTest::TooShortEdgesAreRefused() {
  model::MeshOptions options;
  options.edge_mm = 1.0;
  QVERIFY_THROWS_EXCEPTION(InputError, model::mesh_surface(test::sphere(0.06, 4), options, RunContext()));
  options.edge_mm = -3.0;
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
}

void MeshSurfaceTest::TorusKeepsItsHole() {
  const TriangleMesh surface = test::torus(0.06, 0.025, 64, 32);
  const auto mesh = model::mesh_surface(surface, with_vertices(500), RunContext());
  require_good(*mesh, surface, 500, 0.06);
  QCOMPARE(euler_characteristic(boundary_surface(*mesh).mesh), 0);
}

void MeshSurfaceTest::BoxWithSharpEdgesIsFilled() {
  const TriangleMesh surface = test::box({0.12, 0.08, 0.06});
  const auto mesh = model::mesh_surface(surface, with_vertices(600), RunContext());
  require_good(*mesh, surface, 600, 0.06);
  QCOMPARE(euler_characteristic(boundary_surface(*mesh).mesh), 2);
}

void MeshSurfaceTest::ThinPlateHasAManifoldBoundary() {
  const TriangleMesh surface = test::box({0.15, 0.1, 0.012});
  const auto mesh = model::mesh_surface(surface, with_vertices(400), RunContext());
  const TriangleMesh boundary = boundary_surface(*mesh).mesh;
  QVERIFY(is_closed(boundary));
  int pieces = 0;
  connected_components(boundary, &pieces);
  QCOMPARE(pieces, 1);
}

void MeshSurfaceTest::SameInputGivesTheSameBits() {
  const TriangleMesh surface = test::torus(0.06, 0.03, 48, 24);
  const auto first = model::mesh_surface(surface, with_vertices(300), RunContext());
  std::vector<std::unique_ptr<double[]>> clutter;  // other addresses for the second run
  for (int i = 0; i < 1000; ++i)
    clutter.push_back(std::make_unique<double[]>(static_cast<std::size_t>(17 + i % 91)));
  const auto second = model::mesh_surface(surface, with_vertices(300), RunContext());
  QVERIFY(first->vertices == second->vertices);
  QVERIFY(first->tetrahedra == second->tetrahedra);
  QVERIFY(first->labels == second->labels);
}

void MeshSurfaceTest::InwardNormalsGiveTheSameMesh() {
  TriangleMesh surface = test::sphere(0.06, 3);
  const auto outwards = model::mesh_surface(surface, with_vertices(150), RunContext());
  surface.triangles.col(1).swap(surface.triangles.col(2));
  const auto inwards = model::mesh_surface(surface, with_vertices(150), RunContext());
  QVERIFY(outwards->vertices.isApprox(inwards->vertices, 1e-9));
}

void MeshSurfaceTest::SpecksAreDropped() {
  const TriangleMesh surface =
      test::joined(test::sphere(0.06, 4), test::moved(test::sphere(0.008, 2), {0.09, 0, 0}));
  const auto mesh = model::mesh_surface(surface, with_vertices(150), RunContext());
  require_good(*mesh, test::sphere(0.06, 4), 150, 0.08);
}

void MeshSurfaceTest::SeveralLargePiecesAreRefused() {
  const TriangleMesh surface =
      test::joined(test::sphere(0.06, 3), test::moved(test::sphere(0.05, 3), {0.2, 0, 0}));
  QVERIFY_THROWS_EXCEPTION(InputError, model::mesh_surface(surface, with_vertices(150), RunContext()));
}

void MeshSurfaceTest::OpenSurfaceIsRefused() {
  TriangleMesh surface = test::sphere(0.06, 3);
  surface.triangles.conservativeResize(surface.triangle_count() - 1, 3);
  QVERIFY_THROWS_EXCEPTION(InputError, model::mesh_surface(surface, with_vertices(150), RunContext()));
}

void MeshSurfaceTest::NotANumberIsRefused() {
  TriangleMesh surface = test::sphere(0.06, 2);
  surface.vertices(3, 1) = std::numeric_limits<double>::quiet_NaN();
  QVERIFY_THROWS_EXCEPTION(InputError, model::mesh_surface(surface, with_vertices(150), RunContext()));
}

void MeshSurfaceTest::EmptySurfaceIsRefused() {
  QVERIFY_THROWS_EXCEPTION(InputError, model::mesh_surface({}, with_vertices(150), RunContext()));
}

void MeshSurfaceTest::OptionsOutOfRangeAreRefused() {
  QVERIFY_THROWS_EXCEPTION(InputError, with_vertices(3).validate());
  model::MeshOptions options;
  options.lesion_refinement = 0.0;
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
}

void MeshSurfaceTest::CancelGivesNothing() {
  auto flag = std::make_shared<CancelFlag>();
  // Asked for once the meshing runs, not before it starts.
  const RunContext context(
      [&](double fraction, std::string_view) {
        if (fraction > 0.3) flag->request();
      },
      flag, 1);
  QVERIFY(!model::mesh_surface(test::sphere(0.06, 4), with_vertices(2000), context).has_value());
}

void MeshSurfaceTest::ProgressNeverGoesBack() {
  double last = 0.0;
  bool monotone = true;
  const RunContext context(
      [&](double fraction, std::string_view) {
        monotone = monotone && fraction >= last - 1e-12;
        last = fraction;
      },
      nullptr, 1);
  model::mesh_surface(test::sphere(0.06, 3), with_vertices(200), context);
  QVERIFY(monotone);
  QVERIFY(last > 0.99);
}

void MeshSurfaceTest::RealLiverMeetsThePaper() {
  const std::filesystem::path path = test::data_folder() / "liver_models" / "liver.vtk";
  if (!std::filesystem::exists(path)) QSKIP("liver_models is not here (set GLISSON_DATA)");
  const TriangleMesh liver = split_components(read_triangle_mesh(path, LengthUnit::millimetre)).front();
  const auto mesh = model::mesh_surface(liver, with_vertices(550), RunContext());
  require_good(*mesh, liver, 550, 0.05);
  // The paper: 0.2 mm on average at 547 nodes, from the mesh's boundary nodes to the fine surface.
  const BoundarySurface boundary = boundary_surface(*mesh);
  QVERIFY(summarise(distances_to_surface(boundary.mesh.vertices, liver)).mean < 0.2e-3);
  QVERIFY(surface_distance(boundary.mesh, liver).backward.mean < 2e-3);
}

QTEST_APPLESS_MAIN(MeshSurfaceTest)
#include "mesh_surface_test.moc"
