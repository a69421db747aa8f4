// SPDX-License-Identifier: GPL-3.0-or-later
// From a CT to a model on the command line: import, edit, model.
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>

#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/topology.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/io.h"
#include "network_files.h"
#include "program.h"

#include "../support/ball_ct.h"
#include "../volume/dicom_bytes.h"
#include "../volume/dicomdir_bytes.h"
#include "../volume/zip_bytes.h"

using namespace glisson;
using test::ball;
using test::Ran;
using test::write_text;
namespace fs = std::filesystem;

class PatientCommandsTest : public QObject, private test::Program {
  Q_OBJECT
 private slots:
  void init() { make_folder(); }
  void cleanup() { remove_folder(); }

  void SeriesOfAFolderAreListed();
  void ADicomdirOpensItsMedium();
  void ALiverIsFoundWithoutAClick();
  void OneMoreClickCorrectsAroundItOnly();
  void AnOwnNetworkLabelsTheCt();
  void CorrectionsByHandAreReplacedOnlyWhenToldTo();
  void LabelsOfAnotherGridAreRefusedAndTheCaseStands();
  void ANoteOfTwoStepsIsToldOnce();
  void AnotherImageTakesNoCaseUnasked();
  void ACaseOfAnotherVersionIsRefused();
  void SeveralLargeComponentsAreRefused();
  void AModelComesFromAListOfSurfacesAndItsTreesAreEdited();
  void EditsAreStepsOfTheCaseAndCanBeUndone();
  void ABadScriptOfEditsLeavesTheCase();

 private:
  /// A case a.glisson with an empty CT of 40 x 40 x 30 voxels of 2 mm.
  void import_small_ct() const;
};

void PatientCommandsTest::import_small_ct() const {
  Image image;
  image.grid.size = {40, 40, 30};
  image.grid.spacing_mm = {2.0, 2.0, 2.0};
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(
      std::vector<std::int16_t>(static_cast<std::size_t>(image.grid.voxel_count()), 70));
  write_image(at("ct.nrrd"), image);
  QCOMPARE(run({"import", "ct.nrrd", "--case", "a.glisson"}).code, 0);
}

void PatientCommandsTest::SeriesOfAFolderAreListed() {
  fs::create_directories(at("ct"));
  const auto write = [&](const char* name, int slices, const char* kind) {
    test::HandSlice slice;
    slice.series += std::string(".") + std::to_string(slices);
    slice.description = name;
    slice.other["0008|0008"] = kind;
    for (int k = 0; k < slices; ++k)
      write_text(at("ct") / (std::string(name) + std::to_string(k)), test::dicom_of(k, slice));
  };
  write("scout", 1, "ORIGINAL\\PRIMARY\\LOCALIZER");
  write("copy", 40, "DERIVED\\SECONDARY");
  write("venous", 24, "ORIGINAL\\PRIMARY\\AXIAL");
  const Ran ran = run({"import", "ct", "--list", "--json", "series.json"});
  QCOMPARE(ran.code, 0);
  const QJsonObject json =
      QJsonDocument::fromJson(QByteArray::fromStdString(read_file(at("series.json")))).object();
  const QString all = QString::fromStdString(read_file(at("series.json")));
  QVERIFY2(ran.out.contains("venous | portal venous | 24 slices | 0.80 × 1.10 × 2.50 mm"),
           qPrintable(ran.out));
  QVERIFY2(ran.out.indexOf("venous") < ran.out.indexOf("copy") &&
               ran.out.indexOf("copy") < ran.out.indexOf("scout"),
           qPrintable(ran.out));
  QVERIFY(ran.out.contains("derived from other images") && ran.out.contains("few slices; scout (localizer)"));
  QVERIFY(!json.isEmpty() && all.contains("1.2.826.0.1.3680043.2.1125.1.24"));
  QVERIFY(!fs::exists(at("a.glisson")));
  // What is first can be taken by its UID.
  QCOMPARE(run({"import", "ct", "--series", "1.2.826.0.1.3680043.2.1125.1.24", "--case", "a.glisson"}).code,
           0);
  refused({"import", "nowhere", "--list"}, "nowhere");
  // The same as a hospital's archive.
  std::vector<test::ZipFile> files;
  for (const auto& entry : fs::directory_iterator(at("ct")))
    files.push_back({"DISC/" + entry.path().filename().string(), read_file(entry.path()), true});
  write_text(at("ct.zip"), test::zip_of(files));
  const Ran packed = run({"import", "ct.zip", "--list"});
  QCOMPARE(packed.code, 0);
  QVERIFY2(packed.out.contains("venous | portal venous | 24 slices"), qPrintable(packed.out));
  QCOMPARE(
      run({"import", "ct.zip", "--series", "1.2.826.0.1.3680043.2.1125.1.24", "--case", "b.glisson"}).code,
      0);
  files.front().encrypted = true;
  write_text(at("ct.zip"), test::zip_of(files));
  refused({"import", "ct.zip", "--list"}, "encrypted");
}

void PatientCommandsTest::ADicomdirOpensItsMedium() {
  fs::create_directories(at("disc/IMAGES"));
  std::vector<std::string> named;
  for (int k = 0; k < 24; ++k) {
    named.push_back("IMAGES\\IM" + std::to_string(k));
    write_text(at("disc/IMAGES") / ("IM" + std::to_string(k)), test::dicom_of(k, {}));
  }
  const std::string whole = test::dicomdir_of(named);
  write_text(at("disc/DICOMDIR"), whole);
  const Ran listed = run({"import", "disc/DICOMDIR", "--list"});
  QCOMPARE(listed.code, 0);
  QVERIFY2(listed.out.contains("24 slices"), qPrintable(listed.out));
  QCOMPARE(run({"import", "disc/DICOMDIR", "--case", "a.glisson"}).code, 0);
  // A copy that ended early: told or read, as far as its names go, but never in words that name no remedy.
  for (std::size_t length = 140; length < whole.size(); length += 97) {
    write_text(at("disc/DICOMDIR"), whole.substr(0, length));
    const Ran cut = run({"import", "disc/DICOMDIR", "--list"});
    QVERIFY2(cut.code == 0 || cut.error.contains("Name the folder"), qPrintable(cut.error));
  }
}

void PatientCommandsTest::ALiverIsFoundWithoutAClick() {
  write_image(at("ct.nrrd"), test::ball_ct(60.0));
  QCOMPARE(run({"import", "ct.nrrd", "--case", "a.glisson"}).code, 0);
  refused({"segment", "--case", "a.glisson"}, "--seeds", 2);
  const Ran ran = run({"segment", "--case", "a.glisson", "--propose", "--json", "s.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QVERIFY2(ran.out.contains("proposal"), qPrintable(ran.out));
  const double ml = figures("s.json")["label_parenchyma_ml"].toDouble(),
               ball_ml = 4.0 / 3.0 * M_PI * 6.0 * 6.0 * 6.0;
  QVERIFY2(std::abs(ml - ball_ml) < 0.1 * ball_ml, qPrintable(QString::number(ml)));
}

void PatientCommandsTest::OneMoreClickCorrectsAroundItOnly() {
  write_image(at("ct.nrrd"), test::ball_ct(60.0));
  QCOMPARE(run({"import", "ct.nrrd", "--case", "a.glisson"}).code, 0);
  write_text(at("one.json"), R"({"liver": [[-80, 0, 0]]})");
  write_text(at("two.json"), R"({"liver": [[-80, 0, 0]], "background": [[-80, 48, 0]]})");
  const QStringList segment = {"segment", "--case", "a.glisson"};
  QCOMPARE(run(segment + QStringList{"--seeds", "one.json", "--json", "before.json"}).code, 0);
  refused(segment + QStringList{"--seeds", "one.json", "--correct"},
          "has no click on the liver, beside it, on its veins or on a lesion that the case does not have");
  refused(segment + QStringList{"--seeds", "two.json", "--correct", "--propose"},
          "--correct, --propose: give one of them", 2);
  const Ran ran = run(segment + QStringList{"--seeds", "two.json", "--correct", "--json", "after.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  const double before = figures("before.json")["label_parenchyma_ml"].toDouble(),
               after = figures("after.json")["label_parenchyma_ml"].toDouble(),
               changed = figures("after.json")["changed_ml"].toDouble();
  QVERIFY2(changed > 0.2 && changed < 0.5 * before, qPrintable(QString::number(changed)));
  QVERIFY(std::abs(before - after - changed) < 1e-6);
}

void PatientCommandsTest::AnOwnNetworkLabelsTheCt() {
  Image image = test::ct_of({40, 36, 30}, [](const Eigen::Vector3i& v) { return v.x() < 20 ? 110 : -100; });
  image.grid.spacing_mm = {3.0, 3.0, 3.0};
  write_image(at("ct.nrrd"), image);
  QCOMPARE(run({"import", "ct.nrrd", "--case", "a.glisson"}).code, 0);
  test::write_network(at("."), test::bright_or_dark({1, 1, 16, 16}),
                      R"({"window_hu": [0, 200], "channels": ["background", "parenchyma"]})");
  const QStringList segment = {"segment", "--case", "a.glisson", "--network", "net.onnx"};
  const Ran ran = run(segment + QStringList{"--json", "s.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QCOMPARE(figures("s.json")["label_parenchyma_ml"].toDouble(), 20.0 * 36 * 30 * 0.027);
  refused(segment + QStringList{"--propose"}, "--network, --propose: give one of them", 2);
  write_text(at("net.json"), R"({"window_hu": [0, 200], "channels": ["background", "liver"]})");
  refused(segment, "net.json: channels: names \"liver\"");
}

void PatientCommandsTest::CorrectionsByHandAreReplacedOnlyWhenToldTo() {
  Image image;
  image.grid.size = {40, 40, 36};
  image.grid.spacing_mm = {3.0, 3.0, 3.0};
  image.grid.origin_mm = {-58.5, -58.5, -52.5};
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < 36; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i)
        voxels.push_back(image.grid.p_in_ct(Eigen::Vector3d(i, j, k)).xyz.norm() < 36e-3 ? 110 : -100);
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
  write_image(at("ct.nrrd"), image);
  write_text(at("seeds.json"), R"({"liver": [[0, 0, 0]]})");
  write_text(at("edits.json"),
             R"({"edits": [{"tool": "paint", "label": "parenchyma", "brush": "ball", "radius_mm": 9,
      "path_mm": [[0, 0, 39]]}]})");
  QCOMPARE(run({"import", "ct.nrrd", "--case", "a.glisson"}).code, 0);
  const QStringList segment = {"segment", "--case", "a.glisson", "--seeds", "seeds.json", "--json", "s.json"};
  QCOMPARE(run(segment).code, 0);
  const Ran edited = run({"edit", "--case", "a.glisson", "--script", "edits.json"});
  QVERIFY2(edited.code == 0, qPrintable(edited.error));
  const std::string corrected = read_file(at("a.glisson/labels.seg.nrrd"));
  const Ran told = run(segment);
  QVERIFY(told.code != 0);
  QVERIFY2(told.error.contains("--keep-edited") && told.error.contains("--replace-edited"),
           qPrintable(told.error));
  const double lost = figures("s.json")["lost_parenchyma_ml"].toDouble();
  QVERIFY(lost > 0.5 && figures("s.json")["hand_corrected_voxels_changed"].toDouble() > 0.0);
  QCOMPARE(read_file(at("a.glisson/labels.seg.nrrd")), corrected);
  refused(segment + QStringList{"--keep-edited", "--replace-edited"}, "give one of them", 2);
  QCOMPARE(run(segment + QStringList{"--keep-edited"}).code, 0);
  QCOMPARE(figures("s.json")["lost_parenchyma_ml"].toDouble(), lost);
  QVERIFY(run(segment).code != 0);  // they are a hand's still
  QCOMPARE(run(segment + QStringList{"--replace-edited"}).code, 0);
  QCOMPARE(run(segment).code, 0);
  // A drawn lesion is found anew by a click on it; there is none, so that its drawn diameter counts.
  write_text(at("edits.json"), R"({"edits": [{"tool": "paint", "label": "lesion_1", "brush": "ball",
      "radius_mm": 9, "path_mm": [[0, 0, 0]]}]})");
  QCOMPARE(run({"edit", "--case", "a.glisson", "--script", "edits.json"}).code, 0);
  write_text(at("more.json"),
             R"({"liver": [[0, 0, 0]], "lesions": [[[3, 0, 0]]], "lesion_diameters_mm": [24]})");
  const std::string drawn = read_file(at("a.glisson/labels.seg.nrrd"));
  const QStringList correct = {"segment",   "--case",    "a.glisson", "--seeds",
                               "more.json", "--correct", "--json",    "s.json"};
  refused(correct, "lesion_1: was corrected by hand");
  QVERIFY(figures("s.json")["gained_lesion_1_ml"].toDouble() > 0.5);
  QCOMPARE(read_file(at("a.glisson/labels.seg.nrrd")), drawn);
  QCOMPARE(run(correct + QStringList{"--replace-edited"}).code, 0);
  QVERIFY(read_file(at("a.glisson/labels.seg.nrrd")) != drawn);
}

void PatientCommandsTest::LabelsOfAnotherGridAreRefusedAndTheCaseStands() {
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

/// The labels' import and the model's build both find the liver left of the vena cava.
void PatientCommandsTest::ANoteOfTwoStepsIsToldOnce() {
  VolumeGrid grid;
  grid.size = {60, 50, 40};
  grid.spacing_mm = {3.0, 3.0, 3.0};
  grid.origin_mm = {-88.5, -73.5, -58.5};
  LabelVolume labels(grid);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 60; ++i) {
        const Eigen::Vector3d mm = 1e3 * grid.p_in_ct(Eigen::Vector3d(i, j, k)).xyz;
        if (mm.cwiseQuotient(Eigen::Vector3d(70.0, 55.0, 45.0)).norm() < 1.0)
          labels.set({i, j, k}, structure::kParenchyma);
        if (std::hypot(mm.x() + 60.0, mm.y() - 50.0) < 12.0) labels.set({i, j, k}, structure::kVenaCava);
      }
  write_labels(at("l.seg.nrrd"), labels,
               {structure_info(structure::kParenchyma), structure_info(structure::kVenaCava)});
  const QStringList model = {"model", "--labels", "l.seg.nrrd", "--vertices", "200", "--case", "a.glisson"};
  refused(model, "--left-liver");
  const Ran ran = run(model + QStringList{"--left-liver"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QCOMPARE(ran.out.count("note: The liver lies to the left of the vena cava"), qsizetype{1});
  QVERIFY(read_file(at("a.glisson/case.json")).find("liver.perhaps_mirrored") != std::string::npos);
}

/// It may be another patient's: their labels and model would stay beside it.
void PatientCommandsTest::AnotherImageTakesNoCaseUnasked() {
  import_small_ct();
  const std::string before = read_file(at("a.glisson/image.nrrd"));
  write_image(at("other.nrrd"), test::ball_ct(60.0));
  const QStringList import = {"import", "other.nrrd", "--case", "a.glisson"};
  refused(import, "a.glisson: is a case already");
  refused(import, "--replace");
  QVERIFY(read_file(at("a.glisson/image.nrrd")) == before);
  const Ran ran = run(import + QStringList{"--replace"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QVERIFY(read_file(at("a.glisson/image.nrrd")) != before);
}

void PatientCommandsTest::ACaseOfAnotherVersionIsRefused() {
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

void PatientCommandsTest::SeveralLargeComponentsAreRefused() {
  const TriangleMesh one = boundary_surface(ball()).mesh;
  TriangleMesh two = one;
  two.vertices.conservativeResize(2 * one.vertices.rows(), 3);
  two.vertices.bottomRows(one.vertices.rows()) = one.vertices.rowwise() + Eigen::RowVector3d(0.25, 0.0, 0.0);
  two.triangles.conservativeResize(2 * one.triangles.rows(), 3);
  two.triangles.bottomRows(one.triangles.rows()) = one.triangles.array() + one.vertex_count();
  write_triangle_mesh(at("two.vtp"), two, LengthUnit::millimetre);
  refused({"model", "--surfaces", "two.vtp", "--case", "a.glisson"}, "pieces");
}

void PatientCommandsTest::AModelComesFromAListOfSurfacesAndItsTreesAreEdited() {
  write_triangle_mesh(at("a.ply"), boundary_surface(ball()).mesh, LengthUnit::millimetre);
  write_text(at("list.json"), R"({"structures": {"liver": "a.ply"}})");
  QCOMPARE(run({"model", "--surfaces", "list.json", "--case", "a.glisson", "--edge", "25"}).code, 0);
  refused({"model", "--surfaces", "list.json", "--case", "b.glisson", "--tree-edits", "none.json"},
          "none.json");
  // What would be left unread.
  const QStringList model = {"model", "--surfaces", "list.json", "--case", "b.glisson"};
  write_text(at("codes.json"), R"({"1": "parenchyma"})");
  refused(model + QStringList{"--labels", "l.nii"}, "--labels, --surfaces: give one of them", 2);
  refused(model + QStringList{"--codes", "codes.json"}, "--codes: needs labels", 2);
  write_text(at("edits.json"), R"({"edits": [{"edit": "prune", "at": [0, 0, 0]}]})");
  // A bare liver has no vessel to prune.
  refused({"model", "--surfaces", "list.json", "--case", "b.glisson", "--tree-edits", "edits.json"},
          "edit 1 (prune)");
}

void PatientCommandsTest::EditsAreStepsOfTheCaseAndCanBeUndone() {
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
  // A truth that lies on other voxels is told, and does not take the work along.
  VolumeGrid other = read_labels(at("labels.nii.gz")).voxels.grid();
  other.spacing_mm *= 1.5;
  write_labels(at("other.nrrd"), LabelVolume(other), {});
  ran = run({"edit", "--case", "a.glisson", "--undo", "1", "--truth", "other.nrrd"});
  QVERIFY2(ran.code == 1 && ran.error.contains("other.nrrd"), qPrintable(ran.error));
  ran = run({"edit", "--case", "a.glisson", "--redo", "1"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QVERIFY(run({"edit", "--case", "a.glisson", "--undo", "9"}).error.contains("no step to undo"));
}

void PatientCommandsTest::ABadScriptOfEditsLeavesTheCase() {
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
  const Ran spleen = run({"edit", "--case", "a.glisson", "--review", "spleen=approved"});
  QCOMPARE(spleen.code, 2);
  QVERIFY2(spleen.error.contains("states are not_started, in_progress, to_review, approved."),
           qPrintable(spleen.error));
}

QTEST_GUILESS_MAIN(PatientCommandsTest)
#include "patient_commands_test.moc"
