// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/mesh_io.h"

#include <QtTest>
#include <fstream>
#include <random>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/geometry/ply_file.h"
#include "glisson/geometry/topology.h"

using namespace glisson;
namespace fs = std::filesystem;

namespace {

TetMesh two_tetrahedra() {
  TetMesh mesh;
  mesh.vertices.resize(5, 3);
  mesh.vertices << 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0.1, 0.1, 0.1234567890123;
  mesh.tetrahedra.resize(2, 4);
  mesh.tetrahedra << 0, 1, 2, 3, 1, 2, 3, 4;
  mesh.labels = {1, 16};
  return mesh;
}

TriangleMesh tetrahedron_surface() {
  TetMesh mesh = two_tetrahedra();
  return boundary_surface(mesh).mesh;
}

void write_text(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// The message of the InputError that the call throws; empty when it throws none.
template <class Call>
std::string complaint(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

fs::path data_folder() {
  if (const char* folder = std::getenv("GLISSON_DATA")) return folder;
  const char* source = std::getenv("GLISSON_SOURCE_DIR");
  return source != nullptr ? fs::path(source) / "../shared/data" : fs::path();
}

}  // namespace

class MeshIoTest : public QObject {
  Q_OBJECT
 private slots:
  void TetrahedraSurviveTheFile_data();
  void TetrahedraSurviveTheFile();
  void SurfacesSurviveTheFile_data();
  void SurfacesSurviveTheFile();
  void UnitsScaleOnlyTheCoordinates();
  void GmshVersionsSayTheSame_data();
  void GmshVersionsSayTheSame();
  void GmshFileIsReadAsWritten();
  void AllNegativeMeshIsTurned();
  void SomeInvertedTetrahedraAreRefused();
  void UnusedNodeIsRefused();
  void NotANumberIsRefused();
  void TruncatedFilesAreRefused_data();
  void TruncatedFilesAreRefused();
  void MissingFileIsAFileError();
  void UnknownExtensionIsRefused();
  void HexahedraAreRefused();
  void IndexOutOfRangeIsRefused_data();
  void IndexOutOfRangeIsRefused();
  void PlyEncodingsSayTheSame();
  void PlyWithInflatedCountIsRefused();
  void MutatedFilesNeverCrash_data();
  void MutatedFilesNeverCrash();
  void ObjPolygonsAndNegativeIndices();
  void AsciiAndBinaryStlAgree();
  void TellsVolumesFromSurfaces();
  void NodeListSurvivesTheFile();
  void NodeListNamesTheBadLine();
  void NodeNumbersBeyondTheMeshAreRefused();
  void LiverOf150MetresIsRefusedWithTheUnit();
  void FailedWriteLeavesTheOldFile();
  void LegacyVersionsSayTheSame_data();
  void LegacyVersionsSayTheSame();
  void LegacyWithWrongCountsIsRefused_data();
  void LegacyWithWrongCountsIsRefused();
  void TriangleStripsAreOpened();
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

namespace {
// The same two tetrahedra, tags with holes, a triangle and a point among the elements.
const char* const kMsh2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 100 0 0\n5 0 100 0\n7 0 0 100\n9 100 100 "
    "100\n$EndNodes\n$Elements\n4\n1 15 2 0 1 1\n2 2 2 0 1 1 2 5\n3 4 2 1 1 1 2 5 7\n4 4 2 16 2 2 5 7 9\n"
    "$EndElements\n";
const char* const kMsh40 =
    "$MeshFormat\n4 0 8\n$EndMeshFormat\n$Entities\n1 0 0 2\n1 0 0 0 0 0 0 0\n1 0 0 0 100 100 100 1 1 0\n"
    "2 0 0 0 100 100 100 1 16 0\n$EndEntities\n$Nodes\n2 5\n1 3 0 4\n1 0 0 0\n2 100 0 0\n5 0 100 0\n7 0 0 "
    "100\n"
    "2 3 0 1\n9 100 100 100\n$EndNodes\n$Elements\n3 3\n1 2 2 1\n1 1 2 5\n1 3 4 1\n2 1 2 5 7\n2 3 4 1\n3 2 5 "
    "7 "
    "9\n$EndElements\n";
const char* const kMsh41 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n1 0 0 2\n1 0 0 0 0\n1 0 0 0 100 100 100 1 1 0\n"
    "2 0 0 0 100 100 100 1 16 0\n$EndEntities\n$Nodes\n2 5 1 9\n3 1 0 4\n1\n2\n5\n7\n0 0 0\n100 0 0\n0 100 "
    "0\n0 "
    "0 100\n3 2 0 1\n9\n100 100 100\n$EndNodes\n$Elements\n3 3 1 3\n2 1 2 1\n1 1 2 5\n3 1 4 1\n2 1 2 5 7\n3 "
    "2 4 "
    "1\n3 2 5 7 9\n$EndElements\n";
}  // namespace

void MeshIoTest::GmshVersionsSayTheSame_data() {
  QTest::addColumn<QString>("text");
  QTest::newRow("2.2") << kMsh2;
  QTest::newRow("4.0") << kMsh40;
  QTest::newRow("4.1") << kMsh41;
}

void MeshIoTest::GmshVersionsSayTheSame() {
  QFETCH(QString, text);
  TemporaryFolder folder;
  const fs::path path = folder.path() / "mesh.msh";
  write_text(path, text.toStdString());
  const TetMesh mesh = read_tet_mesh(path, LengthUnit::millimetre);
  Points vertices(5, 3);
  vertices << 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0.1, 0.1, 0.1;
  QVERIFY(mesh.vertices.isApprox(vertices, 1e-15));
  QVERIFY(mesh.tetrahedra == two_tetrahedra().tetrahedra);
  QVERIFY((mesh.labels == std::vector<int>{1, 16}));
}

void MeshIoTest::GmshFileIsReadAsWritten() {
  TemporaryFolder folder;
  const fs::path path = folder.path() / "mesh.msh";
  std::string text = kMsh2;
  write_text(path, text.replace(text.find("4 4 2 16 2 2 5 7 9"), 18, "4 4 2 16 2 2 5 7 8"));
  QVERIFY(complaint([&] { read_tet_mesh(path, LengthUnit::millimetre); }).find("node") != std::string::npos);
  write_text(path, "$MeshFormat\n2.2 1 8\n");
  QVERIFY(complaint([&] { read_tet_mesh(path, LengthUnit::millimetre); }).find("ascii") != std::string::npos);
  write_text(path, "$MeshFormat\n3 0 8\n");
  QVERIFY(complaint([&] { read_tet_mesh(path, LengthUnit::millimetre); }).find("version 2 or 4") !=
          std::string::npos);
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

void MeshIoTest::TruncatedFilesAreRefused_data() {
  QTest::addColumn<QString>("extension");
  for (const char* extension : {".vtu", ".vtk", ".vtp", ".stl", ".ply"})
    QTest::newRow(extension) << extension;
}

void MeshIoTest::TruncatedFilesAreRefused() {
  QFETCH(QString, extension);
  TemporaryFolder folder;
  const fs::path path = folder.path() / ("mesh" + extension.toStdString());
  const bool volume_format = extension == ".vtu" || extension == ".vtk";
  if (volume_format)
    write_tet_mesh(path, two_tetrahedra(), LengthUnit::millimetre);
  else
    write_triangle_mesh(path, tetrahedron_surface(), LengthUnit::millimetre);
  const std::string whole = read_file(path);
  for (const double share : {0.0, 0.1, 0.3, 0.5, 0.6}) {
    write_text(path, whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
    QVERIFY(!complaint([&] {
               if (volume_format)
                 read_tet_mesh(path, LengthUnit::millimetre);
               else
                 read_triangle_mesh(path, LengthUnit::millimetre);
             }).empty());
  }
}

void MeshIoTest::MissingFileIsAFileError() {
  for (const char* name : {"absent.vtu", "absent.vtk", "absent.msh"})
    QVERIFY_EXCEPTION_THROWN(read_tet_mesh(name, LengthUnit::millimetre), FileError);
  for (const char* name : {"absent.vtp", "absent.stl", "absent.obj", "absent.ply"})
    QVERIFY_EXCEPTION_THROWN(read_triangle_mesh(name, LengthUnit::millimetre), FileError);
  QVERIFY_EXCEPTION_THROWN(read_node_list("absent.xyz", LengthUnit::millimetre), FileError);
  QVERIFY_EXCEPTION_THROWN(is_tetrahedral("absent.stl"), FileError);
  QVERIFY_EXCEPTION_THROWN(write_tet_mesh("no/such/folder/x.vtu", two_tetrahedra(), LengthUnit::metre),
                           FileError);
}

void MeshIoTest::UnknownExtensionIsRefused() {
  QVERIFY_EXCEPTION_THROWN(read_tet_mesh("x.step", LengthUnit::metre), InputError);
  QVERIFY_EXCEPTION_THROWN(read_triangle_mesh("x.step", LengthUnit::metre), InputError);
  QVERIFY_EXCEPTION_THROWN(is_tetrahedral("x.step"), InputError);
  QVERIFY_EXCEPTION_THROWN(write_tet_mesh("x.stl", two_tetrahedra(), LengthUnit::metre), InputError);
  QVERIFY_EXCEPTION_THROWN(write_triangle_mesh("x.vtu", tetrahedron_surface(), LengthUnit::metre),
                           InputError);
}

void MeshIoTest::HexahedraAreRefused() {
  TemporaryFolder folder;
  const fs::path path = folder.path() / "hexahedron.vtk";
  write_text(
      path,
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n0 0 0 1 0 0 1 1 "
      "0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1\nCELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n12\n");
  QVERIFY(complaint([&] { read_tet_mesh(path, LengthUnit::metre); }).find("tetrahedr") != std::string::npos);
}

void MeshIoTest::IndexOutOfRangeIsRefused_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("text");
  QTest::newRow("vtk")
      << "x.vtk"
      << "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n0 0 0 1 0 0 "
         "0 1 0\nPOLYGONS 1 4\n3 0 1 7\n";
  QTest::newRow("obj") << "x.obj"
                       << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n";
  QTest::newRow("obj backwards") << "x.obj"
                                 << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n";
  QTest::newRow("ply")
      << "x.ply"
      << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
         "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 "
         "0\n0 1 0\n3 0 1 3\n";
}

void MeshIoTest::IndexOutOfRangeIsRefused() {
  QFETCH(QString, file);
  QFETCH(QString, text);
  TemporaryFolder folder;
  const fs::path path = folder.path() / file.toStdString();
  write_text(path, text.toStdString());
  QVERIFY(complaint([&] { read_triangle_mesh(path, LengthUnit::metre); }).find("not there") !=
          std::string::npos);
}

void MeshIoTest::PlyEncodingsSayTheSame() {
  const std::string header =
      " 1.0\ncomment by hand\nelement vertex 1\nproperty float x\nproperty short y\nproperty double z\n"
      "property list uchar int many\nend_header\n";
  const std::string little = {0, 0, '\xC0', '\x3F', '\xFE', '\xFF', 0, 0, 0, 0, 0, 0, '\xE0', '\x3F', 2, 7, 0,
                              0, 0, '\xFF', '\xFF', '\xFF', '\xFF'};
  const std::string big = {'\x3F', '\xC0', 0, 0, '\xFF', '\xFE', '\x3F', '\xE0', 0,      0,      0,     0,
                           0,      0,      2, 0, 0,      0,      7,      '\xFF', '\xFF', '\xFF', '\xFF'};
  for (const std::string& content : {"ply\nformat ascii" + header + "1.5 -2 0.5 2 7 -1\n",
                                     "ply\nformat binary_little_endian" + header + little,
                                     "ply\nformat binary_big_endian" + header + big}) {
    const std::vector<PlyElement> elements = parse_ply(content, "test");
    QCOMPARE(elements.size(), std::size_t{1});
    QCOMPARE(elements[0].scalars.at("x")[0], 1.5);
    QCOMPARE(elements[0].scalars.at("y")[0], -2.0);
    QCOMPARE(elements[0].scalars.at("z")[0], 0.5);
    QVERIFY((elements[0].lists.at("many")[0] == std::vector<double>{7.0, -1.0}));
  }
}

void MeshIoTest::PlyWithInflatedCountIsRefused() {
  const std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  QVERIFY_EXCEPTION_THROWN(parse_ply(head + "4000000000\nproperty float x\nend_header\nabcd", "test"),
                           InputError);
  QVERIFY_EXCEPTION_THROWN(parse_ply(head + "-1\nproperty float x\nend_header\nabcd", "test"), InputError);
  QVERIFY_EXCEPTION_THROWN(
      parse_ply(head + "1\nproperty list int float x\nend_header\n\xFF\xFF\xFF\x7F", "test"), InputError);
  QVERIFY_EXCEPTION_THROWN(parse_ply("plx\n", "test"), InputError);
  QVERIFY_EXCEPTION_THROWN(parse_ply("ply\nformat ascii 1.0\nelement vertex 0\n", "test"), InputError);
}

void MeshIoTest::MutatedFilesNeverCrash_data() {
  QTest::addColumn<QString>("extension");
  for (const char* extension : {".vtu", ".vtk", ".vtp", ".stl", ".ply", ".obj", ".msh"})
    QTest::newRow(extension) << extension;
}

void MeshIoTest::MutatedFilesNeverCrash() {
  QFETCH(QString, extension);
  TemporaryFolder folder;
  const fs::path path = folder.path() / ("mesh" + extension.toStdString());
  const bool volume_format = extension == ".vtu" || extension == ".vtk" || extension == ".msh";
  if (extension == ".msh")
    write_text(path, kMsh41);
  else if (volume_format)
    write_tet_mesh(path, two_tetrahedra(), LengthUnit::millimetre);
  else
    write_triangle_mesh(path, tetrahedron_surface(), LengthUnit::millimetre);
  const std::string whole = read_file(path);
  std::mt19937 random(7);
  int refused = 0;
  for (int round = 0; round < 300; ++round) {
    std::string mutant = whole;
    for (int change = 0; change < 1 + round % 4; ++change) {
      const std::size_t at = random() % mutant.size();
      if (random() % 4 == 0)
        mutant.erase(at, 1 + random() % 8);
      else
        mutant[at] = static_cast<char>(random());
    }
    write_text(path, mutant);
    try {
      if (volume_format)
        check_tetrahedra(read_tet_mesh(path, LengthUnit::millimetre), "mutant");
      else
        QVERIFY(read_triangle_mesh(path, LengthUnit::millimetre).vertices.allFinite());
    } catch (const Error&) {
      ++refused;
    }
  }
  QVERIFY(refused > 0);
}

void MeshIoTest::ObjPolygonsAndNegativeIndices() {
  TemporaryFolder folder;
  const fs::path path = folder.path() / "square.obj";
  write_text(path, "# a square\nv 0 0 0\nv 1 0 0\nvn 0 0 1\nv 1 1 0\nv 0 1 0\nf 1/1/1 -3//1 3/2 4\n");
  const TriangleMesh mesh = read_triangle_mesh(path, LengthUnit::metre);
  QCOMPARE(mesh.triangle_count(), 2);
  QVERIFY(std::abs(area(mesh) - 1.0) < 1e-15);
}

void MeshIoTest::AsciiAndBinaryStlAgree() {
  TemporaryFolder folder;
  const TriangleMesh mesh = tetrahedron_surface();
  std::string text = "solid by hand\n";
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d p = 1e3 * mesh.vertex(mesh.triangles(t, k));
      text += "vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) +
              "\n";
    }
    text += "endloop\nendfacet\n";
  }
  const fs::path ascii = folder.path() / "ascii.stl", binary = folder.path() / "binary.stl";
  write_text(ascii, text + "endsolid by hand\n");
  write_triangle_mesh(binary, mesh, LengthUnit::millimetre);
  const TriangleMesh a = read_triangle_mesh(ascii, LengthUnit::millimetre),
                     b = read_triangle_mesh(binary, LengthUnit::millimetre);
  QCOMPARE(a.vertex_count(), 5);
  QVERIFY(a.triangles == b.triangles);
  QVERIFY((a.vertices - b.vertices).cwiseAbs().maxCoeff() < 1e-8);
  write_text(ascii, text.substr(0, text.rfind("vertex")));
  QVERIFY_EXCEPTION_THROWN(read_triangle_mesh(ascii, LengthUnit::millimetre), InputError);
}

void MeshIoTest::TellsVolumesFromSurfaces() {
  TemporaryFolder folder;
  const fs::path volume_path = folder.path() / "a.vtk", surface_path = folder.path() / "b.vtk",
                 vtu = folder.path() / "c.vtu", ply = folder.path() / "d.ply", msh = folder.path() / "e.msh";
  write_tet_mesh(volume_path, two_tetrahedra(), LengthUnit::millimetre);
  write_tet_mesh(vtu, two_tetrahedra(), LengthUnit::millimetre);
  write_triangle_mesh(surface_path, tetrahedron_surface(), LengthUnit::millimetre);
  write_triangle_mesh(ply, tetrahedron_surface(), LengthUnit::millimetre);
  write_text(msh, kMsh41);
  QVERIFY(is_tetrahedral(volume_path));
  QVERIFY(is_tetrahedral(vtu));
  QVERIFY(is_tetrahedral(msh));
  QVERIFY(!is_tetrahedral(surface_path));
  QVERIFY(!is_tetrahedral(ply));
  QVERIFY_EXCEPTION_THROWN(read_tet_mesh(surface_path, LengthUnit::millimetre), InputError);
  QVERIFY_EXCEPTION_THROWN(read_triangle_mesh(volume_path, LengthUnit::millimetre), InputError);
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
  QVERIFY_EXCEPTION_THROWN(read_node_list(path, LengthUnit::metre), InputError);
}

void MeshIoTest::NodeNumbersBeyondTheMeshAreRefused() {
  TemporaryFolder folder;
  const fs::path path = folder.path() / "fixed.txt";
  write_text(path, "0\n4\n2");
  QVERIFY((read_node_numbers(path, 5) == std::vector<int>{0, 4, 2}));
  QVERIFY(complaint([&] { read_node_numbers(path, 4); }).find("line 2") != std::string::npos);
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

void MeshIoTest::FailedWriteLeavesTheOldFile() {
  TemporaryFolder folder;
  const fs::path path = folder.path() / "mesh.vtu";
  write_tet_mesh(path, two_tetrahedra(), LengthUnit::millimetre);
  const std::string before = read_file(path);
  TetMesh broken = two_tetrahedra();
  broken.vertices(0, 0) = std::numeric_limits<double>::quiet_NaN();  // does not read back equal
  QVERIFY_EXCEPTION_THROWN(write_tet_mesh(path, broken, LengthUnit::millimetre), Error);
  QVERIFY(read_file(path) == before);
  TetFile wrong{two_tetrahedra(), {{"short", Eigen::MatrixXd::Zero(2, 1)}}, {}, {}};
  QVERIFY_EXCEPTION_THROWN(write_tet_mesh(path, wrong, LengthUnit::millimetre), PreconditionError);
  QCOMPARE(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1L);
}

void MeshIoTest::LegacyVersionsSayTheSame_data() {
  QTest::addColumn<QString>("text");
  const QString points = "POINTS 5 float\n0 0 0 100 0 0 0 100 0 0 0 100 100 100 100\n";
  const QString types = "CELL_TYPES 2\n10\n10\n";
  const QString data =
      "CELL_DATA 2\nSCALARS label int 1\nLOOKUP_TABLE default\n1 16\nPOINT_DATA 5\nVECTORS u%20mm float\n0 0 "
      "0 1 0 "
      "0 2 0 0 3 0 0 4 0 0\nFIELD FieldData 1\nheat 1 5 double\n1 2 3 4 5\n";
  QTest::newRow("3.0") << "# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET UNSTRUCTURED_GRID\n" + points +
                              "CELLS 2 10\n4 0 1 2 3\n4 1 2 3 4\n" + types + data;
  QTest::newRow("5.1")
      << "# vtk DataFile Version 5.1\nby hand\nASCII\nDATASET UNSTRUCTURED_GRID\n" + points +
             "METADATA\nINFORMATION 0\n\nCELLS 3 8\nOFFSETS vtktypeint64\n0 4 8\nCONNECTIVITY "
             "vtktypeint64\n0 1 2 3 1 2 3 4\n" +
             types + data;
}

void MeshIoTest::LegacyVersionsSayTheSame() {
  QFETCH(QString, text);
  TemporaryFolder folder;
  const fs::path path = folder.path() / "mesh.vtk";
  write_text(path, text.toStdString());
  const TetFile file = read_tet_file(path, LengthUnit::millimetre);
  QVERIFY(file.mesh.tetrahedra == two_tetrahedra().tetrahedra);
  QVERIFY((file.mesh.labels == std::vector<int>{1, 16}));
  QVERIFY(std::abs(file.mesh.vertices(4, 2) - 0.1) < 1e-15);
  QCOMPARE(file.point_data.at("u mm")(3, 0), 3.0);
  QCOMPARE(file.point_data.at("heat")(4, 0), 5.0);
}

void MeshIoTest::LegacyWithWrongCountsIsRefused_data() {
  QTest::addColumn<QString>("cells");
  QTest::newRow("list too long") << "CELLS 1 5\n9 0 1 2 3\nCELL_TYPES 1\n10\n";
  QTest::newRow("negative list") << "CELLS 1 5\n-4 0 1 2 3\nCELL_TYPES 1\n10\n";
  QTest::newRow("fewer cells") << "CELLS 2 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n";
  QTest::newRow("more types") << "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 2\n10\n10\n";
  QTest::newRow("no types") << "CELLS 1 5\n4 0 1 2 3\n";
  QTest::newRow("huge count") << "CELLS 1 4000000000000\n4 0 1 2 3\n";
  QTest::newRow("short tetrahedron") << "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n10\n";
  QTest::newRow("unknown section") << "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nNONSENSE\n";
}

void MeshIoTest::LegacyWithWrongCountsIsRefused() {
  QFETCH(QString, cells);
  TemporaryFolder folder;
  const fs::path path = folder.path() / "mesh.vtk";
  write_text(
      path,
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 0 0 "
      "1 0 0 0 1\n" +
          cells.toStdString());
  QVERIFY(!complaint([&] { read_tet_mesh(path, LengthUnit::metre); }).empty());
}

void MeshIoTest::TriangleStripsAreOpened() {
  TemporaryFolder folder;
  const fs::path path = folder.path() / "strip.vtk";
  write_text(
      path,
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 5 float\n0 0 0 0 1 0 1 0 0 1 1 0 2 "
      "0 0\nTRIANGLE_STRIPS 1 6\n5 0 1 2 3 4\n");
  const TriangleMesh mesh = read_triangle_mesh(path, LengthUnit::metre);
  QCOMPARE(mesh.triangle_count(), 3);
  const Points normals = triangle_normals(mesh);
  for (int t = 1; t < 3; ++t) QVERIFY((normals.row(t) - normals.row(0)).norm() < 1e-12);  // all face one way
  QVERIFY(std::abs(area(mesh) - 1.5) < 1e-12);
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

QTEST_APPLESS_MAIN(MeshIoTest)
#include "mesh_io_test.moc"
