// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as a person meets it: the program itself is run, in a folder of its own.
#include <QtTest>

#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <cmath>
#include <fstream>

#include "glisson/core/files.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/topology.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/volume/io.h"

using namespace glisson;
namespace fs = std::filesystem;

namespace {

struct Ran {
  int code = -1;
  QString out, error;
};

/// A flattened ball of tetrahedra, half axes 0.10 x 0.07 x 0.04 m: a cube's grid, each cell cut into six,
/// mapped.
TetMesh ball(int cells = 6) {
  const int n = cells + 1;
  TetMesh mesh;
  mesh.vertices.resize(n * n * n, 3);
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Eigen::Vector3d cube = 2.0 * Eigen::Vector3d(i, j, k) / cells - Eigen::Vector3d::Ones();
        const double largest = cube.cwiseAbs().maxCoeff();
        const Eigen::Vector3d p = largest > 0.0 ? (cube * largest / cube.norm()).eval() : cube;
        mesh.vertices.row(i + n * (j + n * k)) =
            p.cwiseProduct(Eigen::Vector3d(0.10, 0.07, 0.04)).transpose();
      }
  static constexpr int kPaths[6][3] = {{1, 2, 4}, {1, 4, 2}, {2, 1, 4}, {2, 4, 1}, {4, 1, 2}, {4, 2, 1}};
  std::vector<Eigen::RowVector4i> cells_cut;
  const auto node = [&](int i, int j, int k, int corner) {
    return (i + (corner & 1)) + n * ((j + ((corner >> 1) & 1)) + n * (k + ((corner >> 2) & 1)));
  };
  for (int k = 0; k < cells; ++k)
    for (int j = 0; j < cells; ++j)
      for (int i = 0; i < cells; ++i)
        for (const auto& path : kPaths)
          cells_cut.emplace_back(node(i, j, k, 0), node(i, j, k, path[0]), node(i, j, k, path[0] | path[1]),
                                 node(i, j, k, 7));
  mesh.tetrahedra.resize(static_cast<Eigen::Index>(cells_cut.size()), 4);
  for (std::size_t t = 0; t < cells_cut.size(); ++t)
    mesh.tetrahedra.row(static_cast<Eigen::Index>(t)) = cells_cut[t];
  orient_tetrahedra(mesh);
  return mesh;
}

/// A bend that no rigid motion undoes, some millimetres at the ends.
Points bent(const Points& p, double amount) {
  Points q = p;
  for (Eigen::Index i = 0; i < p.rows(); ++i) q(i, 2) += amount * (p(i, 0) * p(i, 0) / 0.01 - 0.3);
  return q;
}

StereoRig rig() {
  StereoRig made;
  made.left.width = made.right.width = 320;
  made.left.height = made.right.height = 240;
  made.left.matrix << 300, 0, 160, 0, 300, 120, 0, 0, 1;
  made.right.matrix = made.left.matrix;
  made.right_from_left.translation = {-0.005, 0.0, 0.0};
  return made;
}

void write_text(const fs::path& path, const std::string& text) { write_file_atomically(path, text); }

}  // namespace

class CommandsTest : public QObject {
  Q_OBJECT

  std::unique_ptr<TemporaryFolder> folder_;

  fs::path at(const char* name) const { return folder_->path() / name; }
  QString text_of(const char* name) const { return QString::fromStdString(at(name).string()); }
  /// @param locale of the system; its files are in the folder "locales" where they have been made.
  Ran run(const QStringList& arguments, const QString& locale = QStringLiteral("C.UTF-8")) const {
    QProcess process;
    process.setWorkingDirectory(QString::fromStdString(folder_->path().string()));
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove("DISPLAY");
    environment.remove("WAYLAND_DISPLAY");
    // As in a container or a cron job: what Qt then says must not reach the person.
    environment.remove("XDG_RUNTIME_DIR");
    environment.remove("LANGUAGE");
    environment.insert("LC_ALL", locale);
    if (fs::exists(at("locales"))) environment.insert("LOCPATH", text_of("locales"));
    process.setProcessEnvironment(environment);
    process.start(GLISSON_EXECUTABLE, arguments);
    if (!process.waitForFinished(500000)) return {};
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2,
            QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
  }
  QJsonObject figures(const char* name) const {
    return QJsonDocument::fromJson(QByteArray::fromStdString(read_file(at(name)))).object();
  }
  /// How many files there are, to show that a failure left nothing behind.
  int files() const {
    int count = 0;
    for ([[maybe_unused]] const auto& entry : fs::recursive_directory_iterator(folder_->path())) ++count;
    return count;
  }
  void refused(const QStringList& arguments, const QString& mentions, int code = 1) const {
    const int before = files();
    const Ran ran = run(arguments);
    QVERIFY2(ran.code == code, qPrintable(QString::number(ran.code) + ran.error + ran.out));
    QVERIFY2(ran.error.contains(mentions, Qt::CaseInsensitive), qPrintable(ran.error));
    QVERIFY2(ran.error.trimmed().count('\n') == 0, qPrintable(ran.error));
    QCOMPARE(files(), before);
  }

  /// Two plain pictures of that size with the calibration c.yaml.
  void refuse_reconstruction(const QSize& size, const QString& mentions) const;

 private slots:
  void init() { folder_ = std::make_unique<TemporaryFolder>(); }
  void cleanup() { folder_.reset(); }

  void EveryCommandHelps();
  void HelpIsInThePersonsLanguage();
  void NumbersInFilesAreTheSameInEveryLanguage();
  void WrongUsageIsRefusedWithCodeTwo();
  void MissingInputIsNamed();
  void APlaceThatCannotBeWrittenIsRefusedBeforeTheWork();
  void AnEmptyFolderIsRefused();
  void LabelsOfAnotherGridAreRefusedAndTheCaseStands();
  void ACalibrationOfAnotherSizeIsRefused();
  void SwappedCamerasAreRecognised();
  void ACloudWithNanIsRefused();
  void AMeshDamagedOnItsWayIsRefusedInOneSentence();
  void AMeshWithInvertedTetrahedraIsRefused();
  void ALiverOfAHundredMetresIsRefusedWithTheUnit();
  void ACloudInAnotherUnitIsRefusedWithTheUnit();
  void ACaseOfAnotherVersionIsRefused();
  void SeveralLargeComponentsAreRefused();
  void AModelComesFromAListOfSurfacesAndItsTreesAreEdited();
  void AVideoThatEndsEarlyIsRecognised();
  void RegisterFindsAKnownDeformationAndKeepsTheNodeOrder();
  void ASurfaceComesBackAsThatSurface();
  void TrackWritesOneMeshACloud();
  void SimulateWritesItsSteps();
  void EditsAreStepsOfTheCaseAndCanBeUndone();
  void ABadScriptOfEditsLeavesTheCase();

 private:
  /// A case a.glisson with an empty CT of 40 x 40 x 30 voxels of 2 mm.
  void import_small_ct() const;
};

void CommandsTest::EveryCommandHelps() {
  for (const char* command : {"demo", "import", "segment", "edit", "model", "prove", "reconstruct",
                              "register", "track", "render", "overlay", "simulate"}) {
    const Ran ran = run({command, "--help"});
    QCOMPARE(ran.code, 0);
    QVERIFY2(ran.out.contains("--seed") && ran.out.contains("--json") &&
                 ran.out.contains(QString("glisson ") + command),
             qPrintable(ran.out));
  }
  const Ran ran = run({"--help"});
  QCOMPARE(ran.code, 0);
  QVERIFY(ran.out.contains("reconstruct"));
}

void CommandsTest::HelpIsInThePersonsLanguage() {
  QVERIFY(run({"simulate", "--help"}).out.contains("Time step, s."));
  QVERIFY(run({"simulate", "--help"}, "de_DE.UTF-8").out.contains("Zeitschritt, s."));
  QVERIFY(run({"simulate", "--help"}, "fr_FR.UTF-8").out.contains("Pas de temps, s."));
  QVERIFY(run({"--help"}, "de_DE.UTF-8").out.contains("nicht für den klinischen Gebrauch"));
}

void CommandsTest::NumbersInFilesAreTheSameInEveryLanguage() {
  // Germany writes 0,5. The system may lack that locale: it is made here.
  fs::create_directory(at("locales"));
  if (QProcess::execute("localedef", {"-i", "de_DE", "-f", "UTF-8", text_of("locales/de_DE.UTF-8")}) != 0)
    QSKIP("localedef or its sources are not installed");
  TriangleMesh mesh = boundary_surface(ball()).mesh;
  const Eigen::Index liver = mesh.vertices.rows(), triangles = mesh.triangles.rows();
  mesh.vertices.conservativeResize(2 * liver, 3);
  mesh.vertices.bottomRows(liver) =
      (0.1 * mesh.vertices.topRows(liver)).rowwise() + Eigen::RowVector3d(0.2, 0, 0);
  mesh.triangles.conservativeResize(2 * triangles, 3);
  mesh.triangles.bottomRows(triangles) = mesh.triangles.topRows(triangles).array() + static_cast<int>(liver);
  write_triangle_mesh(at("liver.vtp"), mesh, LengthUnit::millimetre);
  const auto case_file = [&](const char* name, const QString& locale) {
    const Ran ran = run({"model", "--surfaces", "liver.vtp", "--case", name}, locale);
    return ran.code == 0 ? QString::fromStdString(read_file(at(name) / "case.json")) : ran.error;
  };
  const QString here = case_file("a.glisson", "C.UTF-8");
  QVERIFY2(here.contains("liver.piece_dropped"), qPrintable(here));
  QCOMPARE(case_file("b.glisson", "de_DE.UTF-8"), here);
}

void CommandsTest::WrongUsageIsRefusedWithCodeTwo() {
  refused({"register", "--no-such-option"}, "no-such-option", 2);
  refused({"register", "--model", "m.vtu"}, "--out", 2);
  refused({"import", "--case", "a.glisson"}, "arguments", 2);
  refused({"--no-such-option"}, "unknown option", 2);
  refused({"demo", "--distance", "12"}, "from 80 to 160", 2);
  refused({"demo", "--headless", "headles"}, "headles: is no option", 2);
  refused({"segment", "--case", "a.glisson", "--seeds", "s.json", "--labels-out", "l.txt"}, ".nrrd", 2);
  refused({"model", "--case", "a.glisson", "--mesh-out", "m.stl"}, "must end in .vtu", 2);
  refused({"model", "--case", "a.glisson", "--edge", "0.5"}, "--edge", 2);
  refused({"model", "--case", "a.glisson", "--vessel-refinement", "2"}, "--vessel-refinement", 2);
  refused({"render", "--case", "a.glisson", "--out", "p.txt"}, ".png", 2);
  refused({"reconstruct", "--out", "c.xyz"}, ".ply", 2);
}

void CommandsTest::MissingInputIsNamed() {
  refused({"import", "nothing.nii.gz", "--case", "a.glisson"}, "nothing.nii.gz");
  refused({"register", "--model", "nothing.vtu", "--cloud", "c.ply", "--out", "r.vtu"}, "nothing.vtu");
  refused({"segment", "--case", "nothing.glisson", "--seeds", "nothing.json"}, "nothing");
  refused({"demo", "--patient", "nothing"}, "nothing");
}

void CommandsTest::APlaceThatCannotBeWrittenIsRefusedBeforeTheWork() {
  write_tet_mesh(at("m.vtu"), ball(), LengthUnit::millimetre);
  const QStringList command = {"register", "--model", "m.vtu", "--cloud", "c.ply", "--out"};
  // The cloud is missing too: that the place is named shows that it is looked at first.
  refused(command + QStringList{"nowhere/r.vtu"}, "nowhere/r.vtu: its folder does not exist");
  refused(command + QStringList{"."}, "is a folder");
  refused(command + QStringList{"r.vtu", "--json", "nowhere/r.json"}, "nowhere/r.json");
  refused({"segment", "--case", "a.glisson", "--seeds", "s.json", "--labels-out", "nowhere/l.nrrd"},
          "nowhere");
  refused(command + QStringList{"r.vtu", "--truth", "no_truth.xyz"}, "no_truth.xyz");
}

void CommandsTest::AnEmptyFolderIsRefused() {
  fs::create_directory(at("empty"));
  refused({"import", "empty", "--case", "a.glisson"}, "empty");
  refused({"model", "--surfaces", "empty", "--case", "a.glisson"}, "empty");
}

void CommandsTest::LabelsOfAnotherGridAreRefusedAndTheCaseStands() {
  VolumeGrid grid;
  grid.size = {24, 20, 16};
  grid.spacing_mm = {4.0, 4.0, 4.0};
  Image image;
  image.grid = grid;
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(
      static_cast<std::size_t>(grid.voxel_count()), std::int16_t{40});
  write_image(at("ct.nrrd"), image);
  QCOMPARE(run({"import", "ct.nrrd", "--case", "a.glisson"}).code, 0);
  const std::string before = read_file(at("a.glisson/case.json"));
  VolumeGrid other = grid;
  other.size = {24, 20, 15};
  LabelVolume labels(other);
  labels.set({3, 3, 3}, structure::kParenchyma);
  write_labels(at("labels.nrrd"), labels, {});
  refused({"model", "--case", "a.glisson", "--labels", "labels.nrrd"}, "labels.nrrd");
  QCOMPARE(read_file(at("a.glisson/case.json")), before);
}

void CommandsTest::refuse_reconstruction(const QSize& size, const QString& mentions) const {
  QImage picture(size, QImage::Format_RGB888);
  picture.fill(Qt::darkRed);
  QVERIFY(picture.save(text_of("l.png")) && picture.save(text_of("r.png")));
  refused(
      {"reconstruct", "--left", "l.png", "--right", "r.png", "--calibration", "c.yaml", "--out", "cloud.ply"},
      mentions);
}

void CommandsTest::ACalibrationOfAnotherSizeIsRefused() {
  stereo::write_calibration(at("c.yaml"), rig());
  refuse_reconstruction({640, 480}, "320x240");
}

void CommandsTest::SwappedCamerasAreRecognised() {
  // Written by hand: the writer of a calibration would not write one that its reader refuses.
  stereo::write_calibration(at("good.yaml"), rig());
  std::string yaml = read_file(at("good.yaml"));
  const auto place = yaml.find("-5.");
  QVERIFY2(place != std::string::npos, yaml.c_str());
  yaml.erase(place, 1);
  write_text(at("c.yaml"), yaml);
  refuse_reconstruction({320, 240}, "swap");
}

void CommandsTest::ACloudWithNanIsRefused() {
  write_tet_mesh(at("m.vtu"), ball(), LengthUnit::millimetre);
  write_text(at("c.ply"),
             "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float "
             "z\nend_header\n1 2 3\n1 nan 3\n");
  refused({"register", "--model", "m.vtu", "--cloud", "c.ply", "--out", "r.vtu"}, "c.ply");
}

void CommandsTest::AMeshDamagedOnItsWayIsRefusedInOneSentence() {
  write_tet_mesh(at("m.vtu"), ball(), LengthUnit::millimetre);
  std::string content = read_file(at("m.vtu"));
  const std::size_t type = content.find("Float64");
  QVERIFY(type != std::string::npos);
  content.replace(type, 7, "Flout64");  // VTK has much to say on that
  write_text(at("m.vtu"), content);
  refused({"register", "--model", "m.vtu", "--cloud", "c.ply", "--out", "r.vtu"}, "m.vtu");
}

void CommandsTest::AMeshWithInvertedTetrahedraIsRefused() {
  TetMesh mesh = ball(2);
  std::string vtk = "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
                    std::to_string(mesh.vertex_count()) + " double\n";
  for (int i = 0; i < mesh.vertex_count(); ++i)
    vtk += std::to_string(1e3 * mesh.vertices(i, 0)) + " " + std::to_string(1e3 * mesh.vertices(i, 1)) + " " +
           std::to_string(1e3 * mesh.vertices(i, 2)) + "\n";
  std::swap(mesh.tetrahedra(3, 0), mesh.tetrahedra(3, 1));
  vtk += "CELLS " + std::to_string(mesh.tetrahedron_count()) + " " +
         std::to_string(5 * mesh.tetrahedron_count()) + "\n";
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
    vtk += "4";
    for (int k = 0; k < 4; ++k) vtk += " " + std::to_string(mesh.tetrahedra(t, k));
    vtk += "\n";
  }
  vtk += "CELL_TYPES " + std::to_string(mesh.tetrahedron_count()) + "\n";
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) vtk += "10\n";
  write_text(at("m.vtk"), vtk);
  refused({"register", "--model", "m.vtk", "--cloud", "c.ply", "--out", "r.vtu"}, "tetrahedron 3");
}

void CommandsTest::ALiverOfAHundredMetresIsRefusedWithTheUnit() {
  write_tet_mesh(at("m.vtu"), ball(), LengthUnit::millimetre);
  refused({"register", "--model", "m.vtu", "--unit", "m", "--cloud", "c.ply", "--out", "r.vtu"}, "mm");
}

void CommandsTest::ACloudInAnotherUnitIsRefusedWithTheUnit() {
  write_tet_mesh(at("m.vtu"), ball(), LengthUnit::millimetre);
  LabelledCloud cloud;
  cloud.points = sample_surface(boundary_surface(ball()).mesh, 100, 4);
  write_cloud(at("c.ply"), cloud);
  refused({"register", "--model", "m.vtu", "--cloud", "c.ply", "--cloud-unit", "m", "--out", "r.vtu"},
          "Read it in mm");
  write_cloud(at("c.ply"), cloud, LengthUnit::metre);
  refused({"register", "--model", "m.vtu", "--cloud", "c.ply", "--out", "r.vtu"}, "Read it in m.");
}

void CommandsTest::ACaseOfAnotherVersionIsRefused() {
  write_tet_mesh(at("m.vtu"), ball(), LengthUnit::millimetre);
  write_triangle_mesh(at("liver.vtp"), boundary_surface(ball()).mesh, LengthUnit::millimetre);
  QCOMPARE(run({"model", "--surfaces", "liver.vtp", "--case", "a.glisson"}).code, 0);
  QJsonObject json = figures("a.glisson/case.json");
  json["version"] = 99;
  const QByteArray later = QJsonDocument(json).toJson();
  write_text(at("a.glisson/case.json"), later.toStdString());
  refused({"register", "--model", "a.glisson", "--cloud", "c.ply", "--out", "r.vtu"}, "newer Glisson");
  refused({"model", "--surfaces", "liver.vtp", "--case", "a.glisson"}, "newer Glisson");
  QCOMPARE(read_file(at("a.glisson/case.json")), later.toStdString());
}

void CommandsTest::SeveralLargeComponentsAreRefused() {
  const TriangleMesh one = boundary_surface(ball()).mesh;
  TriangleMesh two = one;
  two.vertices.conservativeResize(2 * one.vertices.rows(), 3);
  two.vertices.bottomRows(one.vertices.rows()) = one.vertices.rowwise() + Eigen::RowVector3d(0.25, 0.0, 0.0);
  two.triangles.conservativeResize(2 * one.triangles.rows(), 3);
  two.triangles.bottomRows(one.triangles.rows()) = one.triangles.array() + one.vertex_count();
  write_triangle_mesh(at("two.vtp"), two, LengthUnit::millimetre);
  refused({"model", "--surfaces", "two.vtp", "--case", "a.glisson"}, "pieces");
}

void CommandsTest::AModelComesFromAListOfSurfacesAndItsTreesAreEdited() {
  write_triangle_mesh(at("a.ply"), boundary_surface(ball()).mesh, LengthUnit::millimetre);
  write_text(at("list.json"), R"({"structures": {"liver": "a.ply"}})");
  QCOMPARE(run({"model", "--surfaces", "list.json", "--case", "a.glisson", "--edge", "25"}).code, 0);
  refused({"model", "--surfaces", "list.json", "--case", "b.glisson", "--tree-edits", "none.json"},
          "none.json");
  write_text(at("edits.json"), R"({"edits": [{"edit": "prune", "at": [0, 0, 0]}]})");
  // A bare liver has no vessel to prune.
  refused({"model", "--surfaces", "list.json", "--case", "b.glisson", "--tree-edits", "edits.json"},
          "edit 1 (prune)");
}

void CommandsTest::AVideoThatEndsEarlyIsRecognised() {
  const TetMesh mesh = ball();
  write_tet_mesh(at("m.vtu"), mesh, LengthUnit::millimetre);
  TetMesh placed = mesh;
  placed.vertices.rowwise() += Eigen::RowVector3d(0.0, 0.0, 0.15);
  write_tet_mesh(at("start.vtu"), placed, LengthUnit::millimetre);
  stereo::write_calibration(at("c.yaml"), rig());
  {
    stereo::VideoWriter writer(at("whole.mkv"), 640, 240, 30.0);
    Picture picture{640, 240, 3, nullptr};
    for (int i = 0; i < 60; ++i) {
      auto bytes = std::make_shared<std::vector<std::uint8_t>>(640UL * 240 * 3);
      for (std::size_t b = 0; b < bytes->size(); ++b)
        (*bytes)[b] =
            static_cast<std::uint8_t>((b * 2654435761UL + static_cast<std::size_t>(i) * 40503UL) >> 13);
      picture.bytes = bytes;
      writer.write(picture);
    }
    writer.close();
  }
  const std::string whole = read_file(at("whole.mkv"));
  write_text(at("cut.mkv"), whole.substr(0, whole.size() * 3 / 5));
  fs::remove(at("whole.mkv"));
  refused({"track", "--model", "m.vtu", "--start", "start.vtu", "--video", "cut.mkv", "--calibration",
           "c.yaml", "--out", "tracked"},
          "cut.mkv");
}

void CommandsTest::RegisterFindsAKnownDeformationAndKeepsTheNodeOrder() {
  const TetMesh mesh = ball();
  write_tet_mesh(at("m.vtu"), mesh, LengthUnit::millimetre);
  const Points truth = bent(mesh.vertices, 0.012);
  write_node_list(at("truth.xyz"), truth, LengthUnit::millimetre);
  TriangleMesh deformed = boundary_surface(mesh).mesh;
  deformed.vertices = bent(deformed.vertices, 0.012);
  LabelledCloud cloud;
  cloud.points = sample_surface(deformed, 900, 4);
  write_cloud(at("c.ply"), cloud);
  const Ran ran = run({"register", "--model", "m.vtu", "--cloud", "c.ply", "--rigid", "none", "--homogeneous",
                       "--truth", "truth.xyz", "--out", "r.vtu", "--json", "r.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  const QJsonObject json = figures("r.json");
  for (const char* key : {"tre_volume_mean_mm", "tre_volume_max_mm", "tre_surface_mean_mm",
                          "tre_target_mean_mm", "displacement_mean_mm", "seconds"})
    QVERIFY2(json.contains(key), key);
  QVERIFY(json["tre_target_mean_mm"].isNull());  // no lesions: unknown, not zero
  const double before = 1e3 * point_errors(mesh.vertices, truth).mean;
  QVERIFY2(
      json["tre_volume_mean_mm"].toDouble() < 0.4 * before,
      qPrintable(QString::number(json["tre_volume_mean_mm"].toDouble()) + " of " + QString::number(before)));
  const TetFile result = read_tet_file(at("r.vtu"), LengthUnit::millimetre);
  QVERIFY(result.mesh.tetrahedra == mesh.tetrahedra);
  const double error = 1e3 * point_errors(result.mesh.vertices, truth).mean;
  QVERIFY(std::abs(error - json["tre_volume_mean_mm"].toDouble()) < 1e-3);
  QVERIFY(result.field_data.at("cloud_from_model").isApprox(Eigen::MatrixXd::Identity(4, 4)));
}

void CommandsTest::ASurfaceComesBackAsThatSurface() {
  const TriangleMesh surface = boundary_surface(ball(8)).mesh;
  write_triangle_mesh(at("s.vtp"), surface, LengthUnit::millimetre);
  TriangleMesh deformed = surface;
  deformed.vertices = bent(surface.vertices, 0.010);
  LabelledCloud cloud;
  cloud.points = sample_surface(deformed, 900, 4);
  write_cloud(at("c.ply"), cloud);
  const Ran ran = run({"register", "--model", "s.vtp", "--vertices", "300", "--cloud", "c.ply", "--rigid",
                       "none", "--out", "r.vtp"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  const TriangleMesh back = read_triangle_mesh(at("r.vtp"), LengthUnit::millimetre);
  QVERIFY(back.triangles == surface.triangles);
  QVERIFY(point_errors(back.vertices, deformed.vertices).mean <
          0.6 * point_errors(surface.vertices, deformed.vertices).mean);
}

void CommandsTest::TrackWritesOneMeshACloud() {
  const TetMesh mesh = ball();
  write_tet_mesh(at("m.vtu"), mesh, LengthUnit::millimetre);
  for (int frame = 3; frame < 6; ++frame) {
    TriangleMesh surface = boundary_surface(mesh).mesh;
    surface.vertices = bent(surface.vertices, 0.002 * (frame - 2));
    LabelledCloud cloud;
    cloud.points = sample_surface(surface, 600, static_cast<unsigned>(frame));
    const std::string number = "0" + std::to_string(frame);
    write_cloud(at(("cloud_" + number + ".ply").c_str()), cloud);
    write_node_list(at(("truth_" + number + ".xyz").c_str()), bent(mesh.vertices, 0.002 * (frame - 2)),
                    LengthUnit::millimetre);
  }
  const Ran ran =
      run({"track", "--model", "m.vtu", "--start", "m.vtu", "--clouds", "cloud_%02d.ply", "--homogeneous",
           "--truth", "truth_%02d.xyz", "--out", "tracked", "--json", "tracked/t.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QCOMPARE(ran.error, QString());
  for (const char* name :
       {"tracked/registered_03.vtu", "tracked/registered_04.vtu", "tracked/registered_05.vtu"})
    QVERIFY2(fs::exists(at(name)), name);
  const QJsonObject json = figures("tracked/t.json");
  QCOMPARE(json["frames"].toInt(), 3);
  for (const char* key : {"frames_late", "frame_p50_ms", "frame_p99_ms", "tre_volume_mean_mm"})
    QVERIFY2(json.contains(key), key);
  double sum = 0.0;
  for (const char* frame : {"frame_03", "frame_04", "frame_05"}) {
    const QJsonValue error = json[frame + QString("_tre_volume_mean_mm")];
    QVERIFY2(error.isDouble(), frame);
    sum += error.toDouble();
  }
  QVERIFY(std::abs(sum / 3.0 - json["tre_volume_mean_mm"].toDouble()) < 1e-9);
  QVERIFY(json["tre_target_max_mm"].isNull());  // no lesions: unknown, not zero
  const double moved = 1e3 * point_errors(bent(mesh.vertices, 0.004), mesh.vertices).mean;
  QVERIFY2(std::abs(json["displacement_mean_mm"].toDouble() - moved) < 0.5 * moved,
           qPrintable(QString::number(json["displacement_mean_mm"].toDouble())));
  QVERIFY(json["tre_volume_mean_mm"].toDouble() < json["tre_frozen_mean_mm"].toDouble());
}

void CommandsTest::SimulateWritesItsSteps() {
  const TetMesh mesh = ball();
  write_tet_mesh(at("m.vtu"), mesh, LengthUnit::millimetre);
  write_text(at("load.json"),
             "{\"gravity\": {\"change\": [0, 0, -9.81]}, \"fixed\": {\"nodes\": [0, 1, 2, 3, 4, 5, 6]}}");
  const Ran ran = run({"simulate", "--model", "m.vtu", "--load", "load.json", "--steps", "5", "--out",
                       "steps", "--json", "s.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QVERIFY(fs::exists(at("steps")));
  QVERIFY(figures("s.json").contains("displacement_max_mm"));
  refused({"simulate", "--model", "m.vtu", "--load", "nothing.json", "--steps", "5", "--out", "other"},
          "nothing.json");
}

void CommandsTest::import_small_ct() const {
  Image image;
  image.grid.size = {40, 40, 30};
  image.grid.spacing_mm = {2.0, 2.0, 2.0};
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(
      std::vector<std::int16_t>(static_cast<std::size_t>(image.grid.voxel_count()), 70));
  write_image(at("ct.nrrd"), image);
  QCOMPARE(run({"import", "ct.nrrd", "--case", "a.glisson"}).code, 0);
}

void CommandsTest::EditsAreStepsOfTheCaseAndCanBeUndone() {
  import_small_ct();
  write_text(at("edits.json"), R"({"edits": [
    {"tool": "paint", "label": "parenchyma", "brush": "ball", "radius_mm": 20, "path_mm": [[40, 40, 30]]},
    {"tool": "paint", "label": "lesion_1", "brush": "ball", "radius_mm": 8, "path_mm": [[40, 40, 30]]}]})");
  Ran ran = run({"edit", "--case", "a.glisson", "--script", "edits.json", "--labels-out", "labels.nii.gz",
                 "--review", "lesion_1=approved"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  const double voxel = 8.0, ball = 4.0 / 3.0 * 3.14159265;
  std::vector<long> counts = read_labels(at("labels.nii.gz")).voxels.histogram();
  QVERIFY(std::abs(voxel * static_cast<double>(counts[structure::kFirstLesion]) - ball * 512) <
          0.1 * ball * 512);
  QVERIFY(std::abs(voxel * static_cast<double>(counts[structure::kParenchyma]) - ball * (8000 - 512)) <
          0.05 * ball * 8000);
  QCOMPARE(read_labels(at("a.glisson/labels.seg.nrrd")).infos.back().status, std::string("completed"));
  ran = run({"edit", "--case", "a.glisson", "--undo", "1", "--labels-out", "labels.nii.gz"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  counts = read_labels(at("labels.nii.gz")).voxels.histogram();
  QCOMPARE(counts.size(), std::size_t{structure::kParenchyma + 1});
  // With the labels against themselves the figures are those of an expert who agrees.
  ran = run({"edit", "--case", "a.glisson", "--redo", "1", "--truth", "labels.nii.gz", "--json", "f.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QCOMPARE(figures("f.json")["dice_liver"].toDouble(), 1.0);
  QVERIFY(run({"edit", "--case", "a.glisson", "--undo", "9"}).error.contains("no step to undo"));
}

void CommandsTest::ABadScriptOfEditsLeavesTheCase() {
  import_small_ct();
  write_text(at("edits.json"), R"({"edits": [
    {"tool": "paint", "label": "parenchyma", "brush": "ball", "radius_mm": 9, "path_mm": [[40, 40, 30]]},
    {"tool": "paint", "label": "parenchyma", "brush": "ball", "radius_mm": -8, "path_mm": [[40, 40, 30]]}]})");
  const std::string before = read_file(at("a.glisson/case.json"));
  const Ran ran = run({"edit", "--case", "a.glisson", "--script", "edits.json"});
  QCOMPARE(ran.code, 1);
  QVERIFY2(ran.error.contains("edit 2") && ran.error.contains("radius"), qPrintable(ran.error));
  QCOMPARE(read_file(at("a.glisson/case.json")), before);
  QCOMPARE(run({"edit", "--case", "a.glisson"}).code, 2);
  QCOMPARE(run({"edit", "--case", "a.glisson", "--review", "spleen=approved"}).code, 2);
}

QTEST_GUILESS_MAIN(CommandsTest)
#include "commands_test.moc"
