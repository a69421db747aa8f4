// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <fstream>
#include <numbers>
#include <set>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/model/build.h"
#include "shapes.h"

using namespace glisson;
namespace fs = std::filesystem;

namespace {

void save(const fs::path& path, const TriangleMesh& mesh) {
  write_triangle_mesh(path, mesh, LengthUnit::millimetre);
}

const TriangleMesh kLiver = test::sphere(0.07, 4);

bool says(const std::vector<std::string>& notes, const std::string& code) {
  for (const std::string& note : notes)
    if (note.rfind(code, 0) == 0) return true;
  return false;
}

std::string complaint(const fs::path& path, LengthUnit unit) {
  return test::complaint([&] { model::read_surfaces(path, unit); });
}

/// Of two balls, m3.
double volume_of_lens(double r, double s, double apart) {
  const double d = apart;
  return std::numbers::pi * (r + s - d) * (r + s - d) *
         (d * d + 2.0 * d * s - 3.0 * s * s + 2.0 * d * r + 6.0 * r * s - 3.0 * r * r) / (12.0 * d);
}

double volume_of(const TetMesh& mesh, int label) {
  const Eigen::VectorXd volumes = tetrahedron_volumes(mesh);
  double sum = 0.0;
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) sum += mesh.labels[t] == label ? volumes[t] : 0.0;
  return sum;
}

}  // namespace

class SurfacesTest : public QObject {
  Q_OBJECT
 private slots:
  void FolderIsReadByItsNames();
  void EachComponentIsALesion();
  void TumoursComeBeforeCysts();
  void SecondFormatIsIgnoredAndReported();
  void OneNameWrittenTwoWaysIsOneSurface();
  void OneFileIsTheLiver();
  void WrongUnitIsRefusedWithTheRightOne();
  void FolderWithoutLiverIsRefused();
  void MissingFolderIsAFileError();
  void ListNamesFilesAndUnits();
  void BadListsAreRefused_data();
  void BadListsAreRefused();
  void OpenLiverIsRefusedByFile();
  void OpenLesionsAreRefusedByFile();
  void SwappedStructuresAreRefused();
  void OtherUnitOfAVesselIsRefused();
  void OtherFrameOfAVesselIsRefused();
  void VesselsNamedTwiceAreRefused();
  void PiecesOfOneVesselAreOne();
  void MirroredSurfacesAreRefused();
  void SurfacesThatSayRasAreRefused();
  void SurfacesBecomeAModel();
  void LesionOutsideTheLiverIsReported();
  void ALesionThatSticksOutKeepsWhatIsInside();
  void WhatTwoLesionsShareIsOfTheFirst();
  void VesselOutsideTheLiverIsReported();
  void VesselBesideTheLiverIsReported();
};

void SurfacesTest::FolderIsReadByItsNames() {
  TemporaryFolder folder;
  save(folder.path() / "liver.stl", kLiver);
  save(folder.path() / "Portal_Vein.ply", test::torus(0.03, 0.005, 30, 12));
  save(folder.path() / "hepatic_veins.obj", test::torus(0.02, 0.004, 30, 12));
  save(folder.path() / "vena_cava.vtp", test::box({0.02, 0.02, 0.2}));
  save(folder.path() / "spleen.vtk", kLiver);
  const model::SurfaceSet set = model::read_surfaces(folder.path(), LengthUnit::millimetre);
  QVERIFY(std::abs(volume(set.liver) / volume(kLiver) - 1.0) < 1e-5);
  std::set<Label> found;
  for (const NamedSurface& other : set.others) {
    QCOMPARE(other.name, structure_name(other.structure));
    found.insert(other.structure);
  }
  QVERIFY((found == std::set<Label>{structure::kPortalVein, structure::kHepaticVeins, structure::kVenaCava}));
  QVERIFY(says(set.notes, "surfaces.ignored spleen.vtk"));
}

void SurfacesTest::EachComponentIsALesion() {
  TemporaryFolder folder;
  save(folder.path() / "liver.vtk", kLiver);
  save(folder.path() / "liver_tumours.vtk",
       test::joined(test::joined(test::sphere(0.01, 2), test::moved(test::sphere(0.02, 2), {0.04, 0, 0})),
                    test::moved(test::sphere(0.0005, 1), {0, 0.05, 0})));
  const model::SurfaceSet set = model::read_surfaces(folder.path(), LengthUnit::millimetre);
  QCOMPARE(set.others.size(), std::size_t{2});
  QCOMPARE(set.others[0].structure, structure::kFirstLesion);
  QVERIFY(volume(set.others[0].mesh) > volume(set.others[1].mesh));
  QCOMPARE(set.others[1].name, std::string("lesion_2"));
  QVERIFY(says(set.notes, "lesion.crumbs_dropped 1"));
}

void SurfacesTest::TumoursComeBeforeCysts() {
  TemporaryFolder folder;
  save(folder.path() / "liver.vtk", kLiver);
  save(folder.path() / "liver_cysts.vtk", test::sphere(0.02, 2));
  save(folder.path() / "liver_tumours.vtk", test::moved(test::sphere(0.01, 2), {0.04, 0, 0}));
  const model::SurfaceSet set = model::read_surfaces(folder.path(), LengthUnit::millimetre);
  QVERIFY(centroid(set.others[0].mesh).x() > 0.03);
}

void SurfacesTest::SecondFormatIsIgnoredAndReported() {
  TemporaryFolder folder;
  save(folder.path() / "liver.ply", test::sphere(0.05, 2));
  save(folder.path() / "liver.vtk", kLiver);
  const model::SurfaceSet set = model::read_surfaces(folder.path(), LengthUnit::millimetre);
  QVERIFY(std::abs(volume(set.liver) / volume(kLiver) - 1.0) < 1e-9);
  QVERIFY(says(set.notes, "surfaces.of_one_name liver.ply"));
}

void SurfacesTest::OneNameWrittenTwoWaysIsOneSurface() {
  TemporaryFolder folder;
  save(folder.path() / "liver.vtk", kLiver);
  save(folder.path() / "Portal Vein.vtk", test::sphere(0.01, 1));
  save(folder.path() / "portal_vein.ply", test::sphere(0.01, 1));
  const model::SurfaceSet set = model::read_surfaces(folder.path(), LengthUnit::millimetre);
  QCOMPARE(set.others.size(), std::size_t{1});
  QVERIFY(says(set.notes, "surfaces.of_one_name portal_vein.ply"));
  save(folder.path() / "portal-vein.vtk", test::sphere(0.01, 1));
  QVERIFY(complaint(folder.path(), LengthUnit::millimetre)
              .find("is named twice: Portal Vein.vtk and portal-vein.vtk") != std::string::npos);
}

void SurfacesTest::OneFileIsTheLiver() {
  TemporaryFolder folder;
  save(folder.path() / "organ.ply", kLiver);
  const model::SurfaceSet set = model::read_surfaces(folder.path() / "organ.ply", LengthUnit::millimetre);
  QCOMPARE(set.liver.triangle_count(), kLiver.triangle_count());
  QVERIFY(set.others.empty());
}

void SurfacesTest::WrongUnitIsRefusedWithTheRightOne() {
  TemporaryFolder folder;
  save(folder.path() / "liver.vtk", kLiver);
  QVERIFY(complaint(folder.path(), LengthUnit::metre).find("Read it in mm") != std::string::npos);
  QVERIFY(complaint(folder.path() / "liver.vtk", LengthUnit::centimetre).find("Read it in mm") !=
          std::string::npos);
  // 70 mm of radius in inches hold 1437 ml, in centimetres 88.
  TriangleMesh inches = kLiver;
  inches.vertices /= 25.4;
  save(folder.path() / "liver.vtk", inches);
  const std::string told = complaint(folder.path(), LengthUnit::millimetre);
  QVERIFY2(told.find("If it is in inches") != std::string::npos && told.find("in cm") == std::string::npos,
           told.c_str());
}

void SurfacesTest::FolderWithoutLiverIsRefused() {
  TemporaryFolder folder;
  QVERIFY(complaint(folder.path(), LengthUnit::millimetre).find("liver") != std::string::npos);
  save(folder.path() / "portal_vein.vtk", test::sphere(0.01, 1));
  QVERIFY(complaint(folder.path(), LengthUnit::millimetre).find("liver") != std::string::npos);
}

void SurfacesTest::MissingFolderIsAFileError() {
  QVERIFY_THROWS_EXCEPTION(FileError, model::read_surfaces("no/such/folder", LengthUnit::millimetre));
}

void SurfacesTest::ListNamesFilesAndUnits() {
  TemporaryFolder folder;
  save(folder.path() / "a.stl", kLiver);
  write_triangle_mesh(folder.path() / "b.ply", test::torus(0.03, 0.005, 30, 12), LengthUnit::metre);
  save(folder.path() / "c.vtp", test::sphere(0.01, 2));
  save(folder.path() / "d.obj", test::moved(test::sphere(0.012, 2), {0.03, 0, 0}));
  std::ofstream(folder.path() / "patient.json") << R"({"unit": "mm", "structures": {"liver": "a.stl",
    "portal_vein": {"file": "b.ply", "unit": "m"}, "lesions": ["c.vtp", "d.obj"]}})";
  const model::SurfaceSet set = model::read_surfaces(folder.path() / "patient.json", LengthUnit::metre);
  QVERIFY(std::abs(volume(set.liver) / volume(kLiver) - 1.0) < 1e-5);
  QCOMPARE(set.others.size(), std::size_t{3});
  int lesions = 0;
  for (const NamedSurface& other : set.others) {
    if (is_lesion(other.structure)) ++lesions;
    if (other.structure == structure::kPortalVein)
      QVERIFY(std::abs(volume(other.mesh) / volume(test::torus(0.03, 0.005, 30, 12)) - 1.0) < 1e-4);
  }
  QCOMPARE(lesions, 2);
}

void SurfacesTest::BadListsAreRefused_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QByteArray>("says");
  QTest::newRow("no structures") << QByteArray("{}") << QByteArray("structures");
  QTest::newRow("unknown structure") << QByteArray(R"({"structures": {"spleen": "a.stl"}})")
                                     << QByteArray("spleen");
  QTest::newRow("unknown unit") << QByteArray(R"({"unit": "inch", "structures": {"liver": "a.stl"}})")
                                << QByteArray("unit");
  QTest::newRow("no file") << QByteArray(R"({"structures": {"liver": 3}})") << QByteArray("names no file");
  QTest::newRow("no liver") << QByteArray(R"({"structures": {"portal_vein": "a.stl"}})")
                            << QByteArray("liver");
  QTest::newRow("two livers") << QByteArray(R"({"structures": {"liver": ["a.stl", "a.stl"]}})")
                              << QByteArray("named twice");
  QTest::newRow("absent file") << QByteArray(R"({"structures": {"liver": "b.stl"}})") << QByteArray("b.stl");
}

void SurfacesTest::BadListsAreRefused() {
  QFETCH(QByteArray, text);
  QFETCH(QByteArray, says);
  TemporaryFolder folder;
  save(folder.path() / "a.stl", kLiver);
  std::ofstream(folder.path() / "list.json") << text.toStdString();
  const std::string said = test::complaint<Error>(
      [&] { model::read_surfaces(folder.path() / "list.json", LengthUnit::millimetre); });
  QVERIFY2(said.find(says.toStdString()) != std::string::npos, said.c_str());
}

void SurfacesTest::OpenLiverIsRefusedByFile() {
  TemporaryFolder folder;
  TriangleMesh open = kLiver;
  open.triangles.conservativeResize(open.triangle_count() - 3, 3);
  save(folder.path() / "liver.stl", open);
  const std::string said = complaint(folder.path(), LengthUnit::millimetre);
  QVERIFY(said.find("liver.stl") != std::string::npos && said.find("open") != std::string::npos &&
          said.find("Close it") != std::string::npos);
}

void SurfacesTest::OpenLesionsAreRefusedByFile() {
  TemporaryFolder folder;
  TriangleMesh open = test::sphere(0.01, 2);
  open.triangles.conservativeResize(open.triangle_count() - 3, 3);
  save(folder.path() / "liver.stl", kLiver);
  save(folder.path() / "tumours.stl", open);
  const std::string said = complaint(folder.path(), LengthUnit::millimetre);
  QVERIFY(said.find("tumours.stl") != std::string::npos && said.find("closed") != std::string::npos);
}

void SurfacesTest::SwappedStructuresAreRefused() {
  TemporaryFolder folder;
  save(folder.path() / "liver.stl", test::sphere(0.05, 3));
  save(folder.path() / "vena_cava.stl", kLiver);
  const std::string said = complaint(folder.path(), LengthUnit::millimetre);
  QVERIFY(said.find("vena_cava.stl") != std::string::npos && said.find("swapped") != std::string::npos);
}

void SurfacesTest::OtherUnitOfAVesselIsRefused() {
  TemporaryFolder folder;
  save(folder.path() / "liver.stl", kLiver);
  write_triangle_mesh(folder.path() / "portal_vein.stl", test::torus(0.03, 0.005, 30, 12), LengthUnit::metre);
  const std::string said = complaint(folder.path(), LengthUnit::millimetre);
  QVERIFY(said.find("portal_vein.stl") != std::string::npos && said.find("unit") != std::string::npos);
}

void SurfacesTest::OtherFrameOfAVesselIsRefused() {
  TemporaryFolder folder;
  save(folder.path() / "liver.stl", kLiver);
  save(folder.path() / "portal_vein.stl", test::moved(test::torus(0.03, 0.005, 30, 12), {0.4, 0, 0}));
  const std::string said = complaint(folder.path(), LengthUnit::millimetre);
  QVERIFY(said.find("portal_vein.stl") != std::string::npos && said.find("one frame") != std::string::npos);
}

/// Read twice, a vessel would be twice as stiff.
void SurfacesTest::VesselsNamedTwiceAreRefused() {
  TemporaryFolder folder;
  save(folder.path() / "liver.vtk", kLiver);
  save(folder.path() / "portal_vein.stl", test::torus(0.03, 0.005, 30, 12));
  save(folder.path() / "portal_veins.stl", test::torus(0.03, 0.005, 30, 12));
  const std::string told = complaint(folder.path(), LengthUnit::millimetre);
  QVERIFY2(
      told.find("portal_vein: is named twice: portal_vein.stl and portal_veins.stl") != std::string::npos,
      told.c_str());
}

void SurfacesTest::PiecesOfOneVesselAreOne() {
  TemporaryFolder folder;
  save(folder.path() / "liver.vtk", kLiver);
  const TriangleMesh left = test::torus(0.01, 0.004, 30, 12), right = test::moved(left, {0.03, 0, 0});
  save(folder.path() / "left.vtk", left);
  save(folder.path() / "right.vtk", right);
  write_file_atomically(
      folder.path() / "list.json",
      R"({"structures": {"liver": "liver.vtk", "portal_vein": ["left.vtk", "right.vtk"]}})");
  const model::SurfaceSet set = model::read_surfaces(folder.path() / "list.json", LengthUnit::millimetre);
  QCOMPARE(set.others.size(), std::size_t{1});
  QCOMPARE(set.others[0].structure, structure::kPortalVein);
  QCOMPARE(set.others[0].mesh.triangle_count(), left.triangle_count() + right.triangle_count());
  QVERIFY(std::abs(volume(set.others[0].mesh) / (2.0 * volume(left)) - 1.0) < 1e-6);
}

/// Axes that run to the right and the front (RAS) are the commonest slip; a mirrored export looks the same.
void SurfacesTest::MirroredSurfacesAreRefused() {
  const TriangleMesh cava = test::box({0.02, 0.02, 0.2});
  for (const double x : {0.03, -0.03}) {
    TemporaryFolder folder;
    save(folder.path() / "liver.vtk", kLiver);
    save(folder.path() / "vena_cava.vtk", test::moved(cava, {x, 0, 0}));
    const std::string told = complaint(folder.path(), LengthUnit::millimetre);
    QCOMPARE(told.find("to the left of the vena cava") != std::string::npos, x < 0.0);
    const auto taken = model::read_surfaces(folder.path(), LengthUnit::millimetre, LeftLiver::taken);
    QCOMPARE(std::ranges::count(taken.notes, "liver.perhaps_mirrored"), x < 0.0 ? 1L : 0L);
    const auto asked = model::read_surfaces(folder.path(), LengthUnit::millimetre, LeftLiver::asked);
    QCOMPARE(std::ranges::count(asked.notes, "liver.perhaps_mirrored"), 0L);
  }
}

void SurfacesTest::SurfacesThatSayRasAreRefused() {
  for (const char* space : {"LPS", "RAS"}) {
    TemporaryFolder folder;
    save(folder.path() / "liver.ply", kLiver);
    std::string bytes = read_file(folder.path() / "liver.ply");
    bytes.insert(bytes.find("element"), std::string("comment SPACE=") + space + '\n');
    write_file_atomically(folder.path() / "liver.ply", bytes);
    const std::string told = complaint(folder.path() / "liver.ply", LengthUnit::millimetre);
    QCOMPARE(told.find("SPACE: is RAS") != std::string::npos, std::string(space) == "RAS");
  }
}

void SurfacesTest::SurfacesBecomeAModel() {
  model::SurfaceSet set;
  set.liver = kLiver;
  set.others.push_back(
      {structure::kFirstLesion, "lesion_1", test::moved(test::sphere(0.012, 3), {0.03, 0, 0})});
  set.others.push_back(
      {structure::kPortalVein, "portal_vein", test::moved(test::box({0.008, 0.008, 0.09}), {0, 0, -0.03})});
  model::ModelOptions options;
  options.mesh.target_vertices = 300;
  options.target_beams = 10;
  const auto built = model::build_from_surfaces(set, options, RunContext());
  QVERIFY(built->report.quality.min_dihedral_deg >= 10.0);
  QVERIFY(std::abs(built->report.quality.vertices - 300) <= 30);
  QVERIFY((lesion_centres(built->model).at(0).second - Eigen::Vector3d(0.03, 0, 0)).norm() < 2e-3);
  QCOMPARE(built->model.vessels.size(), std::size_t{1});
  const VesselTree& tree = built->model.vessels[0];
  // From where the vessel comes into the liver (z = -70 mm) up.
  QVERIFY(tree.nodes(0, 2) < -0.06 && tree.nodes.col(2).maxCoeff() > 0.005);
  QVERIFY(tree.beams.size() >= 5);
}

void SurfacesTest::LesionOutsideTheLiverIsReported() {
  model::SurfaceSet set;
  set.liver = kLiver;
  set.others.push_back(
      {structure::kFirstLesion, "lesion_1", test::moved(test::sphere(0.012, 3), {0.2, 0, 0})});
  model::ModelOptions options;
  options.mesh.target_vertices = 100;
  const auto built = model::build_from_surfaces(set, options, RunContext());
  QVERIFY(says(built->report.notes, "lesion.outside_liver lesion_1"));
  QVERIFY(lesion_centres(built->model).empty());
}

/// The rest was pushed inwards before, until the whole lesion was in the liver.
void SurfacesTest::ALesionThatSticksOutKeepsWhatIsInside() {
  // Balls of 70 and 15 mm, 66 mm apart.
  const double big = 0.07, small = 0.015, apart = 0.066;
  model::SurfaceSet set;
  set.liver = kLiver;
  set.others.push_back({structure::kFirstLesion, "lesion_1",
                        test::moved(test::sphere(small, 4), apart * Eigen::Vector3d(0.6, 0.64, 0.48))});
  model::ModelOptions options;
  options.mesh.target_vertices = 400;
  const auto built = model::build_from_surfaces(set, options, RunContext());
  const double ratio =
      volume_of(built->model.mesh, structure::kFirstLesion) / volume_of_lens(big, small, apart);
  QVERIFY2(std::abs(ratio - 1.0) < 0.05, qPrintable(QString::number(ratio)));
  const double outside = 100.0 * (1.0 - volume_of_lens(big, small, apart) / volume(test::sphere(small, 4)));
  bool is_told = false;
  for (const std::string& note : built->report.notes)
    if (note.starts_with("lesion.clipped lesion_1 "))
      is_told = std::abs(std::stod(note.substr(note.rfind(' '))) - outside) < 3.0;
  QVERIFY(is_told);
  // What is drawn is what was given.
  QVERIFY(std::abs(volume(built->model.surfaces.back().mesh) / volume(test::sphere(small, 4)) - 1.0) < 1e-9);
}

void SurfacesTest::WhatTwoLesionsShareIsOfTheFirst() {
  const double radius = 0.014, apart = 0.016;
  model::SurfaceSet set;
  set.liver = kLiver;
  const Eigen::Vector3d to_second = apart * Eigen::Vector3d(0.6, 0.64, 0.48);
  set.others.push_back({structure::kFirstLesion, "lesion_1", test::sphere(radius, 4)});
  set.others.push_back(
      {structure::kFirstLesion + 1, "lesion_2", test::moved(test::sphere(radius, 4), to_second)});
  set.others.push_back({structure::kFirstLesion + 2, "lesion_3", test::sphere(0.6 * radius, 4)});
  model::ModelOptions options;
  options.mesh.target_vertices = 500;
  const auto built = model::build_from_surfaces(set, options, RunContext());
  const double whole = volume(set.others[0].mesh),
               second = volume(set.others[1].mesh) - volume_of_lens(radius, radius, apart);
  const double first_ratio = volume_of(built->model.mesh, structure::kFirstLesion) / whole,
               second_ratio = volume_of(built->model.mesh, structure::kFirstLesion + 1) / second;
  QVERIFY2(std::abs(first_ratio - 1.0) < 0.05, qPrintable(QString::number(first_ratio)));
  QVERIFY2(std::abs(second_ratio - 1.0) < 0.05, qPrintable(QString::number(second_ratio)));
  QVERIFY(!says(built->report.notes, "lesion.clipped lesion_1"));
  QVERIFY(says(built->report.notes, "lesion.clipped lesion_2"));
  // The third lies within the first: nothing is left of it.
  QVERIFY(says(built->report.notes, "lesion.without_tetrahedra lesion_3"));
}

void SurfacesTest::VesselOutsideTheLiverIsReported() {
  model::SurfaceSet set;
  set.liver = kLiver;
  set.others.push_back(
      {structure::kPortalVein, "portal_vein", test::moved(test::box({0.01, 0.01, 0.05}), {0.2, 0, 0})});
  model::ModelOptions options;
  options.mesh.target_vertices = 100;
  const auto built = model::build_from_surfaces(set, options, RunContext());
  QVERIFY(says(built->report.notes, "vessels.outside_liver"));
  QVERIFY(built->model.vessels.empty());
}

/// The liver's box has corners that it does not fill: a vessel there is none of its own, with a root or not.
void SurfacesTest::VesselBesideTheLiverIsReported() {
  model::SurfaceSet set;
  set.liver = kLiver;
  set.others.push_back({structure::kPortalVein, "portal_vein",
                        test::moved(test::box({0.01, 0.01, 0.03}), {0.06, 0.06, 0.05})});
  model::ModelOptions options;
  options.mesh.target_vertices = 100;
  options.mesh.vessel_refinement = 0.5;
  options.portal_root = Points::Constant(1, 3, 0.05);
  const auto built = model::build_from_surfaces(set, options, RunContext());
  QVERIFY(says(built->report.notes, "vessels.outside_liver portal_vein"));
  QVERIFY(built->model.vessels.empty());
}

QTEST_APPLESS_MAIN(SurfacesTest)
#include "surfaces_test.moc"
