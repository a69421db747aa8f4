// SPDX-License-Identifier: GPL-3.0-or-later
// What other programs write: versions, encodings and dialects of the mesh formats, whole and damaged.
#include <QTest>
#include <random>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/ply_file.h"
#include "mesh_files.h"

using namespace glisson;
using namespace glisson::test;
namespace fs = std::filesystem;

class MeshFormatsTest : public QObject {
  Q_OBJECT
 private slots:
  void TellsVolumesFromSurfaces();
  void GmshVersionsSayTheSame_data();
  void GmshVersionsSayTheSame();
  void GmshFileIsReadAsWritten();
  void TruncatedFilesAreRefused_data();
  void TruncatedFilesAreRefused();
  void HexahedraAreRefused();
  void IndexOutOfRangeIsRefused_data();
  void IndexOutOfRangeIsRefused();
  void PlyEncodingsSayTheSame();
  void PlyWithInflatedCountIsRefused();
  void PlyOfMoreRowsThanAnOrganNeedsIsRefused();
  void MutatedFilesNeverCrash_data();
  void MutatedFilesNeverCrash();
  void ObjPolygonsAndNegativeIndices();
  void AsciiAndBinaryStlAgree();
  void StlThatBeginsWithNoNumberIsRefusedAtOnce();
  void LegacyVersionsSayTheSame_data();
  void LegacyVersionsSayTheSame();
  void LegacyWithWrongCountsIsRefused_data();
  void LegacyWithWrongCountsIsRefused();
  void TriangleStripsAreOpened();
};

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

bool is_those_two_tetrahedra(const TetMesh& mesh) {
  Points vertices(5, 3);
  vertices << 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0.1, 0.1, 0.1;
  return mesh.vertices.rows() == 5 && mesh.vertices.isApprox(vertices, 1e-15) &&
         mesh.tetrahedra == two_tetrahedra().tetrahedra && mesh.labels == std::vector<int>{1, 16};
}
}  // namespace

void MeshFormatsTest::GmshVersionsSayTheSame_data() {
  QTest::addColumn<QString>("text");
  QTest::newRow("2.2") << kMsh2;
  QTest::newRow("4.0") << kMsh40;
  QTest::newRow("4.1") << kMsh41;
}

void MeshFormatsTest::GmshVersionsSayTheSame() {
  QFETCH(QString, text);
  const WrittenFile file("mesh.msh", text.toStdString());
  QVERIFY(is_those_two_tetrahedra(read_tet_mesh(file.path, LengthUnit::millimetre)));
}

void MeshFormatsTest::GmshFileIsReadAsWritten() {
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

void MeshFormatsTest::TruncatedFilesAreRefused_data() {
  QTest::addColumn<QString>("extension");
  for (const char* extension : {".vtu", ".vtk", ".vtp", ".stl", ".ply"})
    QTest::newRow(extension) << extension;
}

void MeshFormatsTest::TruncatedFilesAreRefused() {
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

void MeshFormatsTest::HexahedraAreRefused() {
  const WrittenFile file(
      "hexahedron.vtk",
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n0 0 0 1 0 0 1 1 "
      "0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1\nCELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n12\n");
  QVERIFY(complaint([&] { read_tet_mesh(file.path, LengthUnit::metre); }).find("tetrahedr") !=
          std::string::npos);
}

void MeshFormatsTest::IndexOutOfRangeIsRefused_data() {
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

void MeshFormatsTest::IndexOutOfRangeIsRefused() {
  QFETCH(QString, file);
  QFETCH(QString, text);
  const WrittenFile written(file.toStdString(), text.toStdString());
  QVERIFY(complaint([&] { read_triangle_mesh(written.path, LengthUnit::metre); }).find("not there") !=
          std::string::npos);
}

void MeshFormatsTest::PlyEncodingsSayTheSame() {
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

void MeshFormatsTest::PlyOfMoreRowsThanAnOrganNeedsIsRefused() {
  const auto content = [](const std::string& count) {
    return "ply\nformat binary_little_endian 1.0\nelement thing " + count +
           "\nproperty list uchar uchar a\nend_header\n";
  };
  QCOMPARE(
      test::refused_field([&] { (void)parse_ply(content("6000000") + std::string(6000000, '\0'), "test"); }),
      std::string("thing"));
  // A list may be empty: other programs write such.
  QVERIFY(parse_ply(content("1") + std::string(1, '\0'), "test")[0].lists.at("a")[0].empty());
}

void MeshFormatsTest::PlyWithInflatedCountIsRefused() {
  const std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  QVERIFY_THROWS_EXCEPTION(InputError,
                           parse_ply(head + "4000000000\nproperty float x\nend_header\nabcd", "test"));
  QVERIFY_THROWS_EXCEPTION(InputError, parse_ply(head + "-1\nproperty float x\nend_header\nabcd", "test"));
  QVERIFY_THROWS_EXCEPTION(
      InputError, parse_ply(head + "1\nproperty list int float x\nend_header\n\xFF\xFF\xFF\x7F", "test"));
  QVERIFY_THROWS_EXCEPTION(InputError, parse_ply("plx\n", "test"));
  QVERIFY_THROWS_EXCEPTION(InputError, parse_ply("ply\nformat ascii 1.0\nelement vertex 0\n", "test"));
}

void MeshFormatsTest::MutatedFilesNeverCrash_data() {
  QTest::addColumn<QString>("extension");
  for (const char* extension : {".vtu", ".vtk", ".vtp", ".stl", ".ply", ".obj", ".msh"})
    QTest::newRow(extension) << extension;
}

void MeshFormatsTest::MutatedFilesNeverCrash() {
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

void MeshFormatsTest::ObjPolygonsAndNegativeIndices() {
  const WrittenFile file("square.obj",
                         "# a square\nv 0 0 0\nv 1 0 0\nvn 0 0 1\nv 1 1 0\nv 0 1 0\nf 1/1/1 -3//1 3/2 4\n");
  const TriangleMesh mesh = read_triangle_mesh(file.path, LengthUnit::metre);
  QCOMPARE(mesh.triangle_count(), 2);
  QVERIFY(std::abs(area(mesh) - 1.0) < 1e-15);
}

void MeshFormatsTest::AsciiAndBinaryStlAgree() {
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
  QVERIFY_THROWS_EXCEPTION(InputError, read_triangle_mesh(ascii, LengthUnit::millimetre));
}

void MeshFormatsTest::StlThatBeginsWithNoNumberIsRefusedAtOnce() {
  // Merging equal vertices sorted by what has no order: each was held against every other, for hours.
  constexpr std::uint32_t kFacets = 200000;
  std::string bytes(80, ' ');
  append_little_endian(bytes, kFacets);
  for (std::uint32_t f = 0; f < kFacets; ++f) {
    for (int k = 0; k < 12; ++k) append_little_endian(bytes, static_cast<float>(12 * f + k));
    bytes.append(2, '\0');
  }
  const float none = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(bytes.data() + 84 + 12, &none, sizeof none);
  const WrittenFile written("mesh.stl", bytes);
  QVERIFY(complaint<InputError>([&] {
            read_triangle_mesh(written.path, LengthUnit::millimetre);
          }).find("vertex 0") != std::string::npos);
}

void MeshFormatsTest::LegacyVersionsSayTheSame_data() {
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

void MeshFormatsTest::LegacyVersionsSayTheSame() {
  QFETCH(QString, text);
  const WrittenFile written("mesh.vtk", text.toStdString());
  const TetFile file = read_tet_file(written.path, LengthUnit::millimetre);
  QVERIFY(is_those_two_tetrahedra(file.mesh));
  QCOMPARE(file.point_data.at("u mm")(3, 0), 3.0);
  QCOMPARE(file.point_data.at("heat")(4, 0), 5.0);
}

void MeshFormatsTest::LegacyWithWrongCountsIsRefused_data() {
  QTest::addColumn<QString>("cells");
  QTest::newRow("list too long") << "CELLS 1 5\n9 0 1 2 3\nCELL_TYPES 1\n10\n";
  QTest::newRow("negative list") << "CELLS 1 5\n-4 0 1 2 3\nCELL_TYPES 1\n10\n";
  QTest::newRow("fewer cells") << "CELLS 2 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n";
  QTest::newRow("more types") << "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 2\n10\n10\n";
  QTest::newRow("no types") << "CELLS 1 5\n4 0 1 2 3\n";
  QTest::newRow("huge count") << "CELLS 1 4000000000000\n4 0 1 2 3\n";
  QTest::newRow("short tetrahedron") << "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n10\n";
  QTest::newRow("half a point") << "CELLS 1 5\n4 0 1 2 2.7\nCELL_TYPES 1\n10\n";
  QTest::newRow("half a length") << "CELLS 1 5\n4.5 0 1 2 3\nCELL_TYPES 1\n10\n";
  QTest::newRow("no number") << "CELLS 1 5\n4 0 1 2 nan\nCELL_TYPES 1\n10\n";
  QTest::newRow("type beyond int") << "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n4294967306\n";
  QTest::newRow("unknown section") << "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nNONSENSE\n";
}

void MeshFormatsTest::LegacyWithWrongCountsIsRefused() {
  QFETCH(QString, cells);
  const WrittenFile file(
      "mesh.vtk",
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 0 0 "
      "1 0 0 0 1\n" +
          cells.toStdString());
  QVERIFY(!complaint([&] { read_tet_mesh(file.path, LengthUnit::metre); }).empty());
}

void MeshFormatsTest::TriangleStripsAreOpened() {
  const WrittenFile file(
      "strip.vtk",
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 5 float\n0 0 0 0 1 0 1 0 0 1 1 0 2 "
      "0 0\nTRIANGLE_STRIPS 1 6\n5 0 1 2 3 4\n");
  const TriangleMesh mesh = read_triangle_mesh(file.path, LengthUnit::metre);
  QCOMPARE(mesh.triangle_count(), 3);
  const Points normals = triangle_normals(mesh);
  for (int t = 1; t < 3; ++t) QVERIFY((normals.row(t) - normals.row(0)).norm() < 1e-12);  // all face one way
  QVERIFY(std::abs(area(mesh) - 1.5) < 1e-12);
}

void MeshFormatsTest::TellsVolumesFromSurfaces() {
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
  QVERIFY_THROWS_EXCEPTION(InputError, read_tet_mesh(surface_path, LengthUnit::millimetre));
  QVERIFY_THROWS_EXCEPTION(InputError, read_triangle_mesh(volume_path, LengthUnit::millimetre));
}

QTEST_APPLESS_MAIN(MeshFormatsTest)
#include "mesh_formats_test.moc"
