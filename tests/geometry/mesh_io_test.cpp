// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/mesh_io.h"

#include <QTest>
#include <cmath>

#include "complaint.h"
#include "data_folder.h"
#include "full_disk.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/geometry/liver_size.h"
#include "mesh_files.h"

using namespace glisson;
using namespace glisson::test;
namespace fs = std::filesystem;

class MeshIoTest : public QObject {
  Q_OBJECT
 private slots:
  void TetrahedraSurviveTheFile_data();
  void TetrahedraSurviveTheFile();
  void SurfacesSurviveTheFile_data();
  void SurfacesSurviveTheFile();
  void UnitsScaleOnlyTheCoordinates();
  void AllNegativeMeshIsTurned();
  void SomeInvertedTetrahedraAreRefused();
  void UnusedNodeIsRefused();
  void LoosePiecesAreRefused();
  void NotANumberIsRefused();
  void MissingFileIsAFileError();
  void UnknownExtensionIsRefused();
  void NodeListSurvivesTheFile();
  void NodeListNamesTheBadLine();
  void NodeNumbersBeyondTheMeshAreRefused();
  void LiverOf150MetresIsRefusedWithTheUnit();
  void InchesAreNotTakenForCentimetres();
  void FailedWriteLeavesTheOldFile();
  void ADiskThatFillsUpLeavesTheOldFile_data();
  void ADiskThatFillsUpLeavesTheOldFile();
  void RealElasticSequenceIsRead();
  void RealLiverSurfacesAreRead();
};

void MeshIoTest::TetrahedraSurviveTheFile_data() {
  QTest::addColumn<QString>("extension");
  QTest::newRow("vtu") << ".vtu";
  QTest::newRow("legacy vtk") << ".vtk";
}

void MeshIoTest::TetrahedraSurviveTheFile() {
  QFETCH(QString, extension);
  TemporaryFolder folder;
  TetFile file;
  file.mesh = two_tetrahedra();
  file.point_data["displacement_mm"] = Eigen::MatrixXd::Random(5, 3);
  file.cell_data["von_mises_pa"] = Eigen::MatrixXd::Random(2, 1);
  file.field_data["cloud_from_model"] = Eigen::MatrixXd::Random(4, 4);
  const fs::path path = folder.path() / ("mesh" + extension.toStdString());
  write_tet_mesh(path, file, LengthUnit::millimetre);
  const TetFile back = read_tet_file(path, LengthUnit::millimetre);
  QVERIFY((back.mesh.vertices - file.mesh.vertices).cwiseAbs().maxCoeff() < 1e-16);
  QVERIFY(back.mesh.tetrahedra == file.mesh.tetrahedra);
  QVERIFY(back.mesh.labels == file.mesh.labels);
  QVERIFY(back.point_data.at("displacement_mm") == file.point_data.at("displacement_mm"));
  QVERIFY(back.cell_data.at("von_mises_pa") == file.cell_data.at("von_mises_pa"));
  QVERIFY(back.field_data.at("cloud_from_model") == file.field_data.at("cloud_from_model"));
}

void MeshIoTest::SurfacesSurviveTheFile_data() {
  QTest::addColumn<QString>("extension");
  QTest::addColumn<double>("tolerance");
  QTest::newRow("vtp") << ".vtp" << 1e-16;
  QTest::newRow("legacy vtk") << ".vtk" << 1e-16;
  QTest::newRow("ply") << ".ply" << 1e-16;
  QTest::newRow("obj") << ".obj" << 1e-9;
  QTest::newRow("stl") << ".stl" << 1e-7;
}

void MeshIoTest::SurfacesSurviveTheFile() {
  QFETCH(QString, extension);
  QFETCH(double, tolerance);
  TemporaryFolder folder;
  TriangleFile file;
  file.mesh = tetrahedron_surface();
  file.point_data["displacement_mm"] = Eigen::MatrixXd::Random(5, 3);
  const fs::path path = folder.path() / ("surface" + extension.toStdString());
  write_triangle_mesh(path, file, LengthUnit::millimetre);
  const TriangleFile back = read_triangle_file(path, LengthUnit::millimetre);
  QCOMPARE(back.mesh.triangle_count(), file.mesh.triangle_count());
  QCOMPARE(back.mesh.vertex_count(), file.mesh.vertex_count());
  QVERIFY(is_closed(back.mesh));
  QVERIFY(std::abs(volume(back.mesh) - volume(file.mesh)) < 1e-6 * volume(file.mesh));
  for (int t = 0; t < back.mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k)
      QVERIFY((back.mesh.vertex(back.mesh.triangles(t, k)) - file.mesh.vertex(file.mesh.triangles(t, k)))
                  .norm() <= tolerance);
  if (extension == ".vtp" || extension == ".vtk")
    QVERIFY(back.point_data.at("displacement_mm") == file.point_data.at("displacement_mm"));
}

void MeshIoTest::UnitsScaleOnlyTheCoordinates() {
  TemporaryFolder folder;
  const TetMesh mesh = two_tetrahedra();
  const fs::path path = folder.path() / "mesh.vtu";
  write_tet_mesh(path, mesh, LengthUnit::metre);
  const TetMesh as_mm = read_tet_mesh(path, LengthUnit::millimetre);
  QVERIFY((as_mm.vertices - 1e-3 * mesh.vertices).cwiseAbs().maxCoeff() < 1e-18);
  const TetMesh as_cm = read_tet_mesh(path, LengthUnit::centimetre);
  QVERIFY((as_cm.vertices - 1e-2 * mesh.vertices).cwiseAbs().maxCoeff() < 1e-17);
}

void MeshIoTest::AllNegativeMeshIsTurned() {
  TemporaryFolder folder;
  TetMesh mesh = two_tetrahedra();
  mesh.tetrahedra.col(2).swap(mesh.tetrahedra.col(3));
  const fs::path path = folder.path() / "mesh.vtk";
  write_tet_mesh(path, mesh, LengthUnit::millimetre);
  const TetMesh back = read_tet_mesh(path, LengthUnit::millimetre);
  QVERIFY(tetrahedron_volumes(back).minCoeff() > 0.0);
  QVERIFY((back.vertices - mesh.vertices).cwiseAbs().maxCoeff() < 1e-16);
}

void MeshIoTest::SomeInvertedTetrahedraAreRefused() {
  TemporaryFolder folder;
  TetMesh mesh = two_tetrahedra();
  std::swap(mesh.tetrahedra(1, 2), mesh.tetrahedra(1, 3));
  const fs::path path = folder.path() / "mesh.vtu";
  write_tet_mesh(path, mesh, LengthUnit::millimetre);
  const std::string message = complaint([&] { read_tet_mesh(path, LengthUnit::millimetre); });
  QVERIFY(message.find("tetrahedron 1") != std::string::npos);
  QVERIFY(message.find("inverted") != std::string::npos);
  // A deformed shape may have some. What is no mesh it may not be, either.
  QVERIFY(read_tet_mesh(path, LengthUnit::millimetre, MeshShape::deformed).tetrahedra == mesh.tetrahedra);
  mesh.tetrahedra.row(1) = mesh.tetrahedra.row(0);
  write_tet_mesh(path, mesh, LengthUnit::millimetre);
  QVERIFY(complaint([&] {
            read_tet_mesh(path, LengthUnit::millimetre, MeshShape::deformed);
          }).find("same nodes") != std::string::npos);
}

void MeshIoTest::UnusedNodeIsRefused() {
  TemporaryFolder folder;
  TetMesh mesh = two_tetrahedra();
  mesh.vertices.conservativeResize(6, 3);
  mesh.vertices.row(5) << 1, 1, 1;
  const fs::path path = folder.path() / "mesh.vtu";
  write_tet_mesh(path, mesh, LengthUnit::millimetre);
  QVERIFY(complaint([&] { read_tet_mesh(path, LengthUnit::millimetre); }).find("vertex 5") !=
          std::string::npos);
}

/// As programs write bodies side by side: what touches has nodes of its own.
void MeshIoTest::LoosePiecesAreRefused() {
  TemporaryFolder folder;
  const fs::path path = folder.path() / "mesh.vtu";
  const TetMesh one = two_tetrahedra();
  const int n = one.vertex_count();
  TetMesh twice;
  twice.vertices.resize(2 * n, 3);
  twice.vertices << one.vertices, one.vertices;
  twice.tetrahedra.resize(4, 4);
  twice.tetrahedra << one.tetrahedra, (one.tetrahedra.array() + n).matrix();
  twice.labels = one.labels;
  twice.labels.insert(twice.labels.end(), one.labels.begin(), one.labels.end());
  write_tet_mesh(path, twice, LengthUnit::millimetre);
  const std::string message = complaint([&] { read_tet_mesh(path, LengthUnit::millimetre); });
  QVERIFY2(message.find("2 pieces") != std::string::npos, message.c_str());
  QVERIFY(message.find("Merge") != std::string::npos);
}

void MeshIoTest::NotANumberIsRefused() {
  TemporaryFolder folder;
  const fs::path surface = folder.path() / "surface.obj";
  write_text(surface, "v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n");
  QVERIFY(complaint([&] { read_triangle_mesh(surface, LengthUnit::metre); }).find("vertex 2") !=
          std::string::npos);
  const fs::path mesh = folder.path() / "mesh.vtk";
  write_text(mesh,
             "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0\n1 0 "
             "0\n0 nan 0\n0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n");
  QVERIFY(!complaint([&] { read_tet_mesh(mesh, LengthUnit::metre); }).empty());
}

void MeshIoTest::MissingFileIsAFileError() {
  for (const char* name : {"absent.vtu", "absent.vtk", "absent.msh"})
    QVERIFY_THROWS_EXCEPTION(FileError, read_tet_mesh(name, LengthUnit::millimetre));
  for (const char* name : {"absent.vtp", "absent.stl", "absent.obj", "absent.ply"})
    QVERIFY_THROWS_EXCEPTION(FileError, read_triangle_mesh(name, LengthUnit::millimetre));
  QVERIFY_THROWS_EXCEPTION(FileError, read_node_list("absent.xyz", LengthUnit::millimetre));
  QVERIFY_THROWS_EXCEPTION(FileError, is_tetrahedral("absent.stl"));
  QVERIFY_THROWS_EXCEPTION(FileError,
                           write_tet_mesh("no/such/folder/x.vtu", two_tetrahedra(), LengthUnit::metre));
}

void MeshIoTest::UnknownExtensionIsRefused() {
  QVERIFY_THROWS_EXCEPTION(InputError, read_tet_mesh("x.step", LengthUnit::metre));
  QVERIFY_THROWS_EXCEPTION(InputError, read_triangle_mesh("x.step", LengthUnit::metre));
  QVERIFY_THROWS_EXCEPTION(InputError, is_tetrahedral("x.step"));
  QVERIFY_THROWS_EXCEPTION(InputError, write_tet_mesh("x.stl", two_tetrahedra(), LengthUnit::metre));
  QVERIFY_THROWS_EXCEPTION(InputError,
                           write_triangle_mesh("x.vtu", tetrahedron_surface(), LengthUnit::metre));
}

void MeshIoTest::NodeListSurvivesTheFile() {
  TemporaryFolder folder;
  const Points nodes = 0.2 * Points::Random(20, 3);
  const fs::path path = folder.path() / "nodes.xyz";
  write_node_list(path, nodes, LengthUnit::millimetre);
  QVERIFY((read_node_list(path, LengthUnit::millimetre) - nodes).cwiseAbs().maxCoeff() < 1e-9);
}

void MeshIoTest::NodeListNamesTheBadLine() {
  TemporaryFolder folder;
  const fs::path path = folder.path() / "nodes.xyz";
  for (const char* text :
       {"# head\n1 2 3\n4 5\n", "\n1 2 3\n4 5 nan\n", "1 2 3\n\n4 5 6 7\n", "1 2 3\n\n4 x 6\n"}) {
    write_text(path, text);
    QVERIFY(complaint([&] { read_node_list(path, LengthUnit::metre); }).find("line 3") != std::string::npos);
  }
  write_text(path, "# nothing\n");
  QVERIFY_THROWS_EXCEPTION(InputError, read_node_list(path, LengthUnit::metre));
}

void MeshIoTest::NodeNumbersBeyondTheMeshAreRefused() {
  TemporaryFolder folder;
  const fs::path path = folder.path() / "fixed.txt";
  write_text(path, "0\n4\n2");
  QVERIFY((read_node_numbers(path, 5) == std::vector<int>{0, 4, 2}));
  QVERIFY(complaint([&] { read_node_numbers(path, 4); }).find("line 2") != std::string::npos);
  // Who gives a file of nodes that are held wants some to be held.
  write_text(path, " \n\n");
  QVERIFY(complaint([&] { read_node_numbers(path, 5); }).find("holds no nodes") != std::string::npos);
}

void MeshIoTest::LiverOf150MetresIsRefusedWithTheUnit() {
  Points box(2, 3);
  box << 0, 0, 0, 150, 20, 30;
  const std::string message = complaint([&] { check_liver_size(box, LengthUnit::metre, "liver.vtk"); });
  QVERIFY(message.find("liver.vtk") != std::string::npos);
  QVERIFY(message.find("Read it in mm") != std::string::npos);
  QVERIFY(complaint([&] { check_liver_size(1e-3 * box, LengthUnit::metre, "liver.vtk"); }).empty());
  QVERIFY(complaint([&] {
            check_liver_size(1e-4 * box, LengthUnit::millimetre, "liver.vtk");
          }).find("Read it in") != std::string::npos);
  QVERIFY(complaint([&] {
            check_liver_size(1e-9 * box, LengthUnit::millimetre, "x");
          }).find("no usual unit") != std::string::npos);
  QVERIFY(plausible_liver_size(1e-3 * box));
}

/// By its diagonal a liver in inches may be one in centimetres; by its volume it is none.
void MeshIoTest::InchesAreNotTakenForCentimetres() {
  // 25 x 15 x 14 cm, half of its box full, in inches that were read as millimetres.
  const Eigen::Vector3d sides = Eigen::Vector3d(0.25, 0.15, 0.14) / 25.4;
  Points box(2, 3);
  box << Eigen::RowVector3d::Zero(), sides.transpose();
  const auto told = [&](double scale, std::optional<double> volume) {
    return complaint([&] { check_liver_size(scale * box, LengthUnit::millimetre, "l.stl", volume); });
  };
  const double held = 0.5 * sides.prod();
  QVERIFY(told(1.0, held).find("If it is in inches") != std::string::npos);
  QVERIFY(told(1.0, held).find("in cm") == std::string::npos);
  QVERIFY(told(1.0, {}).find("Read it in cm; if it is in inches") != std::string::npos);
  // The same liver in centimetres.
  QVERIFY(told(2.54, held * std::pow(2.54, 3)).ends_with("Read it in cm."));
  // A shell of hardly any volume is no liver in any unit.
  QVERIFY(told(1.0, 1e-3 * held).find("no usual unit") != std::string::npos);
}

void MeshIoTest::FailedWriteLeavesTheOldFile() {
  TemporaryFolder folder;
  const fs::path path = folder.path() / "mesh.vtu";
  write_tet_mesh(path, two_tetrahedra(), LengthUnit::millimetre);
  const std::string before = read_file(path);
  TetMesh broken = two_tetrahedra();
  broken.vertices(0, 0) = std::numeric_limits<double>::quiet_NaN();
  QVERIFY_THROWS_EXCEPTION(PreconditionError, write_tet_mesh(path, broken, LengthUnit::millimetre));
  QVERIFY(read_file(path) == before);
  TetFile wrong{two_tetrahedra(), {{"short", Eigen::MatrixXd::Zero(2, 1)}}, {}, {}};
  QVERIFY_THROWS_EXCEPTION(PreconditionError, write_tet_mesh(path, wrong, LengthUnit::millimetre));
  QCOMPARE(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1L);
}

void MeshIoTest::RealElasticSequenceIsRead() {
  const fs::path folder = data_folder() / "elastic_sequence";
  if (!fs::exists(folder)) QSKIP("elastic_sequence is not here (set GLISSON_DATA)");
  const TetMesh mesh = read_tet_mesh(folder / "rest.vtk", LengthUnit::millimetre);
  QCOMPARE(mesh.vertex_count(), 3046);
  QCOMPARE(mesh.tetrahedron_count(), 10703);
  check_liver_size(mesh.vertices, LengthUnit::millimetre, "rest.vtk");
  const Points truth = read_node_list(folder / "truth_00.xyz", LengthUnit::millimetre);
  QCOMPARE(truth.rows(), mesh.vertices.rows());
  QVERIFY((truth - mesh.vertices).rowwise().norm().maxCoeff() < 0.06);
  QVERIFY(!read_node_numbers(folder / "fixed_vertices.txt", 3046).empty());
}

void MeshIoTest::RealLiverSurfacesAreRead() {
  const fs::path folder = data_folder() / "liver_models";
  if (!fs::exists(folder)) QSKIP("liver_models is not here (set GLISSON_DATA)");
  const TriangleMesh liver = read_triangle_mesh(folder / "liver.vtk", LengthUnit::millimetre);
  QVERIFY(is_closed(liver));
  QVERIFY(std::abs(std::abs(volume(liver)) * 1e6 - 2316.0) < 5.0);
  const TriangleMesh other = read_triangle_mesh(folder / "liver.ply", LengthUnit::millimetre);
  QCOMPARE(other.triangle_count(), 4000);
  check_liver_size(other.vertices, LengthUnit::millimetre, "liver.ply");
}

void MeshIoTest::ADiskThatFillsUpLeavesTheOldFile_data() {
  QTest::addColumn<QString>("extension");
  for (const char* extension : {".vtu", ".vtp", ".vtk", ".ply", ".obj", ".stl"})
    QTest::newRow(extension) << extension;
}

void MeshIoTest::ADiskThatFillsUpLeavesTheOldFile() {
  QFETCH(QString, extension);
  TemporaryFolder folder;
  const fs::path path = folder.path() / ("mesh" + extension.toStdString());
  write_text(path, "old");
  const auto write = [&] {
    if (extension == ".vtu")
      write_tet_mesh(path, two_tetrahedra(), LengthUnit::millimetre);
    else
      write_triangle_mesh(path, tetrahedron_surface(), LengthUnit::millimetre);
  };
  for (const rlim_t bytes : {0U, 1U, 60U, 100U}) {
    const FullDisk disk(bytes);
    QVERIFY_THROWS_EXCEPTION(FileError, write());
  }
  QCOMPARE(read_file(path), std::string("old"));
  QCOMPARE(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1L);
  write();
  QVERIFY(read_file(path) != "old");
}

QTEST_APPLESS_MAIN(MeshIoTest)
#include "mesh_io_test.moc"
