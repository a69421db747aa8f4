// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/model/quality.h"
#include "glisson/model/build.h"

#include <QTest>
#include <numbers>
#include <numeric>

#include "glisson/geometry/topology.h"
#include "glisson/patient/label_map.h"
#include "shapes.h"

using namespace glisson;

namespace {

/// A regular tetrahedron of edge sqrt(2), and a flat one beside it.
TetMesh two_tetrahedra() {
  TetMesh mesh;
  mesh.vertices.resize(8, 3);
  mesh.vertices << 0, 0, 0, 1, 1, 0, 1, 0, 1, 0, 1, 1,  //
      5, 0, 0, 6, 0, 0, 5, 1, 0, 5.3, 0.3, 0.05;
  mesh.tetrahedra.resize(2, 4);
  mesh.tetrahedra << 0, 1, 2, 3, 4, 5, 6, 7;
  orient_tetrahedra(mesh);
  mesh.labels = {structure::kParenchyma, structure::kFirstLesion};
  return mesh;
}

}  // namespace

class QualityTest : public QObject {
  Q_OBJECT
 private slots:
  void RegularTetrahedronHasItsAngles();
  void WorstComesFirst();
  void TetrahedraAreDrawnClosed();
  void EdgesAreCountedOnce();
  void LesionsAreMeasuredBothWays();
  void TreesAreCounted();
  void NothingIsMeasuredOnNothing();
  void AnImportedMeshIsComparedWithNoOrgan();
  void NumbersOfAnImportedMeshAreTold();
};

void QualityTest::RegularTetrahedronHasItsAngles() {
  TetMesh mesh = two_tetrahedra();
  mesh.tetrahedra.conservativeResize(1, 4);
  const auto bins = model::dihedral_histogram(mesh);
  QCOMPARE(bins[7], 6);  // acos(1/3) = 70.5 degrees
  QCOMPARE(std::accumulate(bins.begin(), bins.end(), 0), 6);
  const auto both = model::dihedral_histogram(two_tetrahedra());
  QCOMPARE(std::accumulate(both.begin(), both.end(), 0), 12);
  QVERIFY(both[0] + both[1] >= 3);
}

void QualityTest::WorstComesFirst() {
  QCOMPARE(model::worst_tetrahedra(two_tetrahedra(), 5), (std::vector<int>{1, 0}));
  QCOMPARE(model::worst_tetrahedra(two_tetrahedra(), 1), std::vector<int>{1});
  QVERIFY(model::worst_tetrahedra(two_tetrahedra(), 0).empty());
}

void QualityTest::TetrahedraAreDrawnClosed() {
  const TetMesh mesh = two_tetrahedra();
  const TriangleMesh surface = model::tetrahedra_as_surface(mesh, {1, 0});
  QVERIFY(is_closed(surface));
  QVERIFY(std::abs(volume(surface) - volume(mesh)) < 1e-12);
}

void QualityTest::EdgesAreCountedOnce() {
  TetMesh mesh = two_tetrahedra();
  mesh.tetrahedra.conservativeResize(1, 4);
  QVERIFY(std::abs(model::mean_edge_length(mesh) - std::numbers::sqrt2) < 1e-12);
}

void QualityTest::LesionsAreMeasuredBothWays() {
  PatientModel model;
  model.mesh = two_tetrahedra();
  model.surfaces.push_back({structure::kFirstLesion, "lesion_1", test::sphere(0.01, 3)});
  model.surfaces.push_back({structure::kFirstLesion + 1, "lesion_2", test::sphere(0.005, 3)});
  const auto lesions = model::lesion_volumes(model);
  QCOMPARE(lesions.size(), std::size_t{2});
  QCOMPARE(lesions[0].label, structure::kFirstLesion);
  QVERIFY(std::abs(lesions[0].mesh_volume - tetrahedron_volumes(model.mesh)[1]) < 1e-12);
  QVERIFY(std::abs(lesions[0].diameter - 0.02) < 0.0003);
  QCOMPARE(lesions[1].mesh_volume, 0.0);
  // 65552 is 16 in sixteen bits.
  model.mesh.labels[0] = 65552;
  QCOMPARE(model::lesion_volumes(model)[0].mesh_volume, lesions[0].mesh_volume);
  QVERIFY(std::abs(lesions[1].volume / (4.0 / 3.0 * std::numbers::pi * std::pow(0.005, 3)) - 1.0) < 0.03);
}

void QualityTest::TreesAreCounted() {
  VesselTree tree;
  tree.structure = structure::kPortalVein;
  tree.nodes.resize(5, 3);
  tree.nodes << 0, 0, 0, 0, 0, 1, 0, 1, 1, 0, -1, 1, 0, -2, 1;
  tree.radii = {0.5, 0.4, 0.3, 0.3, 0.3};
  tree.beams = {{0, 1}, {1, 2}, {1, 3}, {3, 4}};
  tree.root = 0;
  PatientModel model;
  model.vessels = {tree};
  const auto trees = model::tree_summaries(model);
  QCOMPARE(trees.size(), std::size_t{1});
  QCOMPARE(trees[0].beams, 4);
  QCOMPARE(trees[0].forks, 1);
  QCOMPARE(trees[0].tips, 2);
  QVERIFY(std::abs(trees[0].length - 4.0) < 1e-12);
  QCOMPARE(trees[0].root_radius, 0.5);
}

void QualityTest::NothingIsMeasuredOnNothing() {
  const PatientModel none;
  QVERIFY(model::lesion_volumes(none).empty());
  QVERIFY(model::tree_summaries(none).empty());
  QVERIFY(model::worst_tetrahedra(none.mesh, 3).empty());
  QCOMPARE(model::mean_edge_length(none.mesh), 0.0);
}

/// Zeros would say that it follows the organ perfectly.
void QualityTest::AnImportedMeshIsComparedWithNoOrgan() {
  const model::MeshQuality quality = model::build_from_mesh(two_tetrahedra()).report.quality;
  QCOMPARE(quality.tetrahedra, 2);
  QVERIFY(quality.min_dihedral_deg > 0.0);
  QVERIFY(!quality.organ_fit);
}

void QualityTest::NumbersOfAnImportedMeshAreTold() {
  const auto built = [](const std::vector<int>& labels) {
    TetMesh mesh = two_tetrahedra();
    mesh.labels = labels;
    return model::build_from_mesh(mesh);
  };
  // 2 is somebody's tumour, and 65552 is 16 in sixteen bits.
  for (const auto& [labels, told] : {std::pair(std::vector{1, 16}, "1 parenchyma, 16 lesion_1"),
                                     {std::vector{1, 2}, "1 parenchyma, 2 parenchyma"},
                                     {std::vector{0, 65552}, "0 parenchyma, 65552 parenchyma"}}) {
    const model::BuiltModel mesh = built(labels);
    QCOMPARE(mesh.report.notes, (std::vector<std::string>{std::string("mesh.labels_by_number ") + told}));
    QCOMPARE(lesion_centres(mesh.model).size(), labels[1] == 16 ? 1U : 0U);
    for (const int label : mesh.model.mesh.labels) QVERIFY(label == 1 || label == 16);
  }
  // One number parts nothing, whichever: as gmsh numbers a volume after some surfaces.
  for (const std::vector<int>& labels : {std::vector<int>{}, {1, 1}, {20, 20}}) {
    const model::BuiltModel mesh = built(labels);
    QVERIFY(mesh.report.notes.empty() && lesion_centres(mesh.model).empty());
  }
}

QTEST_APPLESS_MAIN(QualityTest)
#include "quality_test.moc"
