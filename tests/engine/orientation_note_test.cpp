// SPDX-License-Identifier: GPL-3.0-or-later
// A liver without any other organ that is mirrored or upside down is told where it comes in: as labels, as a
// surface, and when its model is built. So is one that ends at what was never scanned.
#include <QTest>
#include <algorithm>

#include "atlas_cases.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/insilico/liver_population.h"
#include "glisson/insilico/patient.h"
#include "glisson/volume/io.h"
#include "glisson/volume/morphology.h"

using namespace glisson;
using namespace glisson::engine;

namespace {

/// The liver of a synthetic patient alone. @param turned_round axes of the grid along which its voxels are in
/// the other order, as in a file whose header says so.
LabelMap liver_alone(const LabelMap& truth, const Eigen::Array3i& turned_round) {
  const std::vector<std::uint8_t> liver = inside_liver(truth);
  const VolumeGrid& grid = truth.voxels.grid();
  LabelMap map{LabelVolume(grid), {structure_info(structure::kParenchyma)}};
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Eigen::Array3i v(i, j, k);
        if (liver[static_cast<std::size_t>(grid.offset(v))] != 0)
          map.voxels.set((turned_round > 0).select(grid.size.array() - 1 - v, v), structure::kParenchyma);
      }
  return map;
}

std::string told(const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    if (note.starts_with("liver.axes_exchanged ")) return note.substr(21);
  return {};
}

model::ModelOptions coarse() {
  model::ModelOptions options;
  options.mesh.target_vertices = 150;
  options.vessels = false;
  return options;
}

}  // namespace

class OrientationNoteTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    insilico::PatientOptions options;
    options.spacing_mm = {4.0, 4.0, 4.0};
    truth_ = insilico::make_patient(options, RunContext())->truth;
    atlas_ = test::built_in_atlas();
  }
  void labelsAreTold_data() {
    QTest::addColumn<int>("axis");
    QTest::addColumn<QString>("wanted");
    QTest::newRow("as it is") << -1 << "";
    QTest::newRow("mirrored") << 0 << "left_right";
    QTest::newRow("upside down") << 2 << "head_feet";
  }
  void labelsAreTold() {
    QFETCH(const int, axis);
    QFETCH(const QString, wanted);
    Eigen::Array3i turned_round(0, 0, 0);
    if (axis >= 0) turned_round[axis] = 1;
    const LabelMap liver = liver_alone(truth_, turned_round);
    TemporaryFolder folder;
    write_labels(folder.path() / "liver.seg.nrrd", liver.voxels, liver.infos);
    const ImportLabels import{folder.path() / "liver.seg.nrrd", {}, atlas_};
    const auto imported = import.apply(CaseState(), RunContext());
    QCOMPARE(told(imported->notes), wanted.toStdString());
    const auto built = BuildModel{coarse(), atlas_}.apply(imported->state, RunContext());
    QCOMPARE(told(built->notes), wanted.toStdString());
    // It stays with the model.
    QCOMPARE(told(built->state[part::model]->report.notes), wanted.toStdString());
  }
  /// What a right hepatectomy leaves lies like a mirrored liver: both are said, and only a person lets it in.
  void aRemnantOnTheLeftIsTakenWhereAPersonSaysSo() {
    VolumeGrid grid;
    grid.size = {20, 10, 10};
    grid.spacing_mm = {5.0, 5.0, 5.0};
    LabelVolume labels(grid);  // x grows to the patient's left
    for (int k = 0; k < 10; ++k) {
      labels.set({4, 5, k}, structure::kVenaCava);
      for (int i = 6; i < 16; ++i) labels.set({i, 5, k}, structure::kParenchyma);
    }
    TemporaryFolder folder;
    write_labels(folder.path() / "left.seg.nrrd", labels,
                 {structure_info(structure::kParenchyma), structure_info(structure::kVenaCava)});
    ImportLabels import{folder.path() / "left.seg.nrrd", {}};
    for (const LabelCodes& codes : {LabelCodes(), LabelCodes{{1, structure::kParenchyma}, {4, 4}}}) {
      import.codes = codes;
      import.left_liver = LeftLiver::refused;
      std::string told;
      try {
        (void)import.apply(CaseState(), RunContext());
      } catch (const InputError& error) {
        told = error.what();
      }
      QVERIFY2(told.find("mirrored, or the liver's right part was removed") != std::string::npos,
               told.c_str());
      QVERIFY2(told.find("--left-liver") != std::string::npos, told.c_str());
      import.left_liver = LeftLiver::taken;
      const auto taken = import.apply(CaseState(), RunContext());
      QVERIFY(taken->state[part::labels]->voxels == labels);
      QCOMPARE(std::ranges::count(taken->notes, "liver.perhaps_mirrored"), 1L);
    }
  }
  void aModelTellsThatItsLiverEndsAtPadding() {
    LabelMap liver = liver_alone(truth_, {0, 0, 0});
    Image image;
    image.grid = liver.voxels.grid();
    std::vector<std::int16_t> voxels(static_cast<std::size_t>(image.grid.voxel_count()), 60);
    const std::vector<std::uint8_t> all = inside_liver(liver);
    const int padded = 3 + bounding_box(image.grid.size, image.grid.spacing_mm, all, 0.0).low.z();
    for (int k = 0; k < padded; ++k)
      for (int j = 0; j < image.grid.size.y(); ++j)
        for (int i = 0; i < image.grid.size.x(); ++i) {
          liver.voxels.set({i, j, k}, structure::kBackground);
          voxels[static_cast<std::size_t>(image.grid.offset({i, j, k}))] = -1024;
        }
    image.voxels = std::make_shared<const std::vector<std::int16_t>>(voxels);
    for (const bool has_image : {false, true}) {
      CaseState state;
      state[part::labels] = std::make_shared<const LabelMap>(liver);
      if (has_image) state[part::image] = std::make_shared<const Image>(image);
      const auto built = BuildModel{coarse()}.apply(state, RunContext());
      const bool is_told = std::ranges::any_of(
          built->notes, [](const std::string& note) { return note.starts_with("liver.cut_off "); });
      QCOMPARE(is_told, has_image);
    }
  }
  void surfacesAreTold() {
    TriangleMesh liver = insilico::population_liver(4711, 4.0).surface;
    TemporaryFolder folder;
    const auto note = [&] {
      write_triangle_mesh(folder.path() / "liver.stl", liver, LengthUnit::millimetre);
      const ImportSurfaces import{folder.path() / "liver.stl", LengthUnit::millimetre, coarse(), atlas_};
      return told(import.apply(CaseState(), RunContext())->notes);
    };
    QCOMPARE(note(), std::string());
    liver.vertices.leftCols(2) *= -1.0;  // RAS
    QCOMPARE(note(), std::string("left_right+front_back"));
  }

 private:
  LabelMap truth_;
  std::shared_ptr<const atlas::Atlas> atlas_;
};

QTEST_APPLESS_MAIN(OrientationNoteTest)
#include "orientation_note_test.moc"
