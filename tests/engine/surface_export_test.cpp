// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces leave a case: each format is read by VTK, where the labels are and as large as they are.
#include <vtkCell.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <Eigen/Geometry>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/export_surfaces.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/script.h"
#include "glisson/engine/surface_export.h"
#include "glisson/model/build.h"
#include "glisson/model/label_surfaces.h"
#include "glisson/volume/io.h"

using namespace glisson;
using namespace glisson::engine;
namespace fs = std::filesystem;

namespace {

/// Volume (ml) and centre (mm) of a body.
struct Body {
  double ml = 0.0;
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();
};

template <class Reader>
vtkSmartPointer<vtkPolyData> read_by(const fs::path& path) {
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// By the tetrahedra between the triangles and the origin.
Body body_in(const fs::path& path) {
  const std::string ending = path.extension().string();
  const vtkSmartPointer<vtkPolyData> data = ending == ".stl"   ? read_by<vtkSTLReader>(path)
                                            : ending == ".ply" ? read_by<vtkPLYReader>(path)
                                            : ending == ".obj" ? read_by<vtkOBJReader>(path)
                                                               : read_by<vtkXMLPolyDataReader>(path);
  Body body;
  double mm3 = 0.0;
  for (vtkIdType n = 0; n < data->GetNumberOfCells(); ++n) {
    Eigen::Matrix3d corners;
    for (int corner = 0; corner < 3; ++corner)
      data->GetPoint(data->GetCell(n)->GetPointId(corner), corners.col(corner).data());
    const double sixth = corners.determinant() / 6.0;
    mm3 += sixth;
    body.centre_mm += 0.25 * sixth * corners.rowwise().sum();
  }
  body.centre_mm /= mm3;
  body.ml = 1e-3 * mm3;
  return body;
}

Body body_of(const LabelVolume& labels, const std::function<bool(Label)>& counts) {
  Body body;
  long voxels = 0;
  const VolumeGrid& grid = labels.grid();
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        if (!counts(labels.at({i, j, k}))) continue;
        ++voxels;
        body.centre_mm += 1e3 * grid.p_in_ct(Eigen::Vector3d(i, j, k)).xyz;
      }
  body.centre_mm /= static_cast<double>(voxels);
  body.ml = 1e-3 * grid.voxel_volume_mm3() * static_cast<double>(voxels);
  return body;
}

Body lesion_in(const LabelVolume& labels, Label lesion) {
  return body_of(labels, [lesion](Label label) { return label == lesion; });
}

/// What a folder holds, by name.
std::vector<fs::path> entries(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder)) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

Cancellable<std::vector<fs::path>> written(const fs::path& folder, const std::string& ending,
                                           const CaseState& state, const RunContext& context = {}) {
  std::vector<std::string> notes;
  return write_case_surfaces(folder, ending, state, context, notes);
}

}  // namespace

class SurfaceExportTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void EachFormatHoldsEachStructureWhereItIs_data();
  void EachFormatHoldsEachStructureWhereItIs();
  void NothingSaysWhoseTheyAre();
  void WhatIsWrittenComesInAgain();
  void LesionsKeepTheirNumbers_data();
  void LesionsKeepTheirNumbers();
  void LesionsThatAreTooSmallAreTold();
  void SurfacesOfSomebodyElseAreNotMixedWithThem();
  void WhatCannotBeWrittenIsRefused();
  void ACancelLeavesNothing();
  void WhatFailsLeavesNothing();

 private:
  fs::path at(const char* name) const { return folder_->path() / name; }
  /// The case with balls in the liver for its lesions instead.
  CaseState with_lesions(const std::map<Label, Eigen::Vector3d>& middles, double radius) const;
  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<Script> script_;
  LabelMap labels_;
};

/// A liver with a vein that leaves it and a lesion, in a CT that lies askew, of a patient with a name.
void SurfaceExportTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  Scan scan;
  scan.source.patient = "Doe^Jane";
  scan.source.patient_id = "4711-x";
  scan.source.birth_date = "1960-01-31";
  VolumeGrid& grid = scan.image.grid;
  grid.size = {90, 76, 50};
  grid.spacing_mm = {2.0, 2.0, 2.5};
  grid.origin_mm = {-40.0, -150.0, 900.0};
  grid.direction = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  grid.direction.col(1) *= -1.0;
  scan.image.modality = Modality::ct;
  scan.image.voxels = std::make_shared<const std::vector<std::int16_t>>(
      std::vector<std::int16_t>(static_cast<std::size_t>(grid.voxel_count()), 70));
  labels_ = {};
  labels_.voxels = LabelVolume(grid);
  const Eigen::Vector3d middle = grid.p_in_ct(0.5 * grid.size.cast<double>()).xyz;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Eigen::Vector3d p = grid.p_in_ct(Eigen::Vector3d(i, j, k)).xyz - middle;
        const bool lesion = (p - Eigen::Vector3d(0.02, 0.01, 0.0)).norm() < 0.012;
        const bool vein = std::hypot(p.y() + 0.015, p.z()) < 0.007 && p.x() < 0.03 && p.x() > -0.065;
        const bool liver = p.cwiseQuotient(Eigen::Vector3d(0.06, 0.045, 0.04)).norm() < 1.0;
        const Label label = lesion  ? structure::kFirstLesion
                            : vein  ? structure::kPortalVein
                            : liver ? structure::kParenchyma
                                    : structure::kBackground;
        if (label != structure::kBackground) labels_.voxels.set({i, j, k}, label);
      }
  for (const Label label : {structure::kParenchyma, structure::kPortalVein, structure::kFirstLesion})
    labels_.infos.push_back(structure_info(label));
  write_labels(at("labels.seg.nrrd"), labels_.voxels, labels_.infos);
  script_ = std::make_unique<Script>(RunContext());
  script_->run(ImportImage{at("ct"), {}, true, {}, std::make_shared<const Scan>(scan)});
  script_->run(ImportLabels{at("labels.seg.nrrd"), {}});
}

void SurfaceExportTest::EachFormatHoldsEachStructureWhereItIs_data() {
  QTest::addColumn<QString>("ending");
  for (const std::string& ending : surface_endings())
    QTest::newRow(ending.c_str()) << QString::fromStdString(ending);
}

void SurfaceExportTest::EachFormatHoldsEachStructureWhereItIs() {
  QFETCH(QString, ending);
  script_->run(ExportSurfaces{at("out"), ending.toStdString()});
  const std::vector<std::uint8_t> inside = inside_liver(labels_);
  LabelVolume liver(labels_.voxels.grid());
  for (int k = 0; k < liver.grid().size.z(); ++k)
    for (int j = 0; j < liver.grid().size.y(); ++j)
      for (int i = 0; i < liver.grid().size.x(); ++i)
        if (inside[static_cast<std::size_t>(liver.grid().offset({i, j, k}))] != 0) liver.set({i, j, k}, 1);
  const auto check = [&](const std::string& name, const Body& wanted, double share) {
    const fs::path path = at("out") / (name + ending.toStdString());
    QVERIFY2(fs::exists(path), path.c_str());
    const Body found = body_in(path);
    QVERIFY2(std::abs(found.ml - wanted.ml) < share * wanted.ml,
             qPrintable(QStringLiteral("%1: %2 of %3 ml").arg(name.c_str()).arg(found.ml).arg(wanted.ml)));
    QVERIFY2((found.centre_mm - wanted.centre_mm).norm() < 0.5,
             qPrintable(QString::number((found.centre_mm - wanted.centre_mm).norm())));
  };
  check("liver", body_of(liver, [](Label label) { return label == 1; }), 0.02);
  check("portal_vein", body_of(labels_.voxels, [](Label l) { return l == structure::kPortalVein; }), 0.05);
  check("lesion_1", body_of(labels_.voxels, [](Label l) { return l == structure::kFirstLesion; }), 0.04);
}

void SurfaceExportTest::NothingSaysWhoseTheyAre() {
  for (const std::string& ending : surface_endings()) {
    const auto files = written(at("out") / ending.substr(1), ending, script_->state());
    QVERIFY(files && files->size() == 3);
    for (const fs::path& file : *files)
      for (const char* word : {"Doe^Jane", "4711-x", "1960-01-31", "labels.seg"})
        QVERIFY2(read_file(file).find(word) == std::string::npos, file.c_str());
  }
}

void SurfaceExportTest::WhatIsWrittenComesInAgain() {
  for (const std::string& ending : surface_endings()) {
    const fs::path out = at("again") / ending.substr(1);
    QVERIFY(surfaces_in(out, ending).empty());
    script_->run(ExportSurfaces{out, ending});
    write_file_atomically(out / ("notes" + ending + ".txt"), std::string("x"));
    // What a person is asked about before it is written over.
    std::vector<std::string> there;
    for (const fs::path& file : surfaces_in(out, ending)) there.push_back(file.stem().string());
    QCOMPARE(there, (std::vector<std::string>{"lesion_1", "liver", "portal_vein"}));
    QVERIFY(surfaces_in(out, ending == ".stl" ? ".ply" : ".stl").empty());
    script_->run(ExportSurfaces{out, ending});  // over itself
    const model::SurfaceSet set = model::read_surfaces(out, LengthUnit::millimetre);
    QVERIFY(set.notes.empty());
    QCOMPARE(set.others.size(), std::size_t{2});
    QVERIFY(std::any_of(set.others.begin(), set.others.end(),
                        [](const NamedSurface& s) { return s.structure == structure::kFirstLesion; }));
  }
}

CaseState SurfaceExportTest::with_lesions(const std::map<Label, Eigen::Vector3d>& middles,
                                          double radius) const {
  auto labels = std::make_shared<LabelMap>(labels_);
  const VolumeGrid& grid = labels->voxels.grid();
  const Eigen::Vector3d middle = grid.p_in_ct(0.5 * grid.size.cast<double>()).xyz;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        if (is_lesion(labels->voxels.at({i, j, k}))) labels->voxels.set({i, j, k}, structure::kParenchyma);
        const Eigen::Vector3d p = grid.p_in_ct(Eigen::Vector3d(i, j, k)).xyz - middle;
        for (const auto& [label, lesion] : middles)
          if ((p - lesion).norm() < radius) labels->voxels.set({i, j, k}, label);
      }
  for (const auto& [label, lesion] : middles) labels->infos.push_back(structure_info(label));
  CaseState state = script_->state();
  state[part::labels] = labels;
  return state;
}

void SurfaceExportTest::LesionsKeepTheirNumbers_data() {
  QTest::addColumn<int>("first");
  QTest::addColumn<int>("last");
  QTest::newRow("eleven") << 1 << 11;
  QTest::newRow("without the first") << 2 << 4;
}

void SurfaceExportTest::LesionsKeepTheirNumbers() {
  QFETCH(int, first);
  QFETCH(int, last);
  std::map<Label, Eigen::Vector3d> middles;
  for (int number = first; number <= last; ++number) {
    const double turn = 0.55 * number;
    middles[static_cast<Label>(structure::kFirstLesion + number - 1)] =
        Eigen::Vector3d(0.042 * std::cos(turn), 0.03 * std::sin(turn), number % 2 == 0 ? 0.013 : -0.013);
  }
  const CaseState state = with_lesions(middles, 0.005);
  QVERIFY(written(at("out"), ".stl", state));
  const model::SurfaceSet set = model::read_surfaces(at("out"), LengthUnit::millimetre);
  std::size_t lesions = 0;
  for (const NamedSurface& surface : set.others) {
    if (!is_lesion(surface.structure)) continue;
    ++lesions;
    QVERIFY(middles.contains(surface.structure));
    const Eigen::Vector3d centre_mm = 1e3 * surface.mesh.vertices.colwise().mean().transpose();
    const double apart =
        (centre_mm - lesion_in(state[part::labels]->voxels, surface.structure).centre_mm).norm();
    QVERIFY2(apart < 1.5, qPrintable(QStringLiteral("%1: %2 mm").arg(surface.structure).arg(apart)));
  }
  QCOMPARE(lesions, middles.size());
}

/// One voxel has 10 mm3.
void SurfaceExportTest::LesionsThatAreTooSmallAreTold() {
  const VolumeGrid& grid = labels_.voxels.grid();
  constexpr Label kSecond = structure::kFirstLesion + 1;
  LabelVolume voxels = labels_.voxels;
  voxels.set(grid.size / 2, kSecond);
  write_labels(at("more.seg.nrrd"), voxels,
               {structure_info(structure::kParenchyma), structure_info(structure::kFirstLesion),
                structure_info(structure::kPortalVein), structure_info(kSecond)});
  script_->run(ImportLabels{at("more.seg.nrrd"), {}});
  const auto outcome = script_->run(ExportSurfaces{at("out"), ".stl"});
  QCOMPARE(outcome->notes, (std::vector<std::string>{"lesion.dropped lesion_2 mm3 10"}));
  QCOMPARE(outcome->figures.at("surfaces_written"), 3.0);
  QVERIFY(!fs::exists(at("out") / "lesion_2.stl") && fs::exists(at("out") / "lesion_1.stl"));
}

void SurfaceExportTest::SurfacesOfSomebodyElseAreNotMixedWithThem() {
  fs::create_directories(at("out"));
  write_file_atomically(at("out") / "lesion_9.obj", std::string("v 0 0 0\n"));
  try {
    written(at("out"), ".stl", script_->state());
    QFAIL("was not refused");
  } catch (const InputError& error) {
    QVERIFY(std::string(error.what()).find("lesion_9.obj") != std::string::npos);
  }
  QVERIFY(!fs::exists(at("out") / "liver.stl"));
}

void SurfaceExportTest::WhatCannotBeWrittenIsRefused() {
  const auto refused = [&](const fs::path& folder, const char* ending, const CaseState& state,
                           const char* mentions) {
    try {
      written(folder, ending, state);
    } catch (const std::exception& error) {
      return std::string(error.what()).find(mentions) != std::string::npos;
    }
    return false;
  };
  QVERIFY(refused(at("out"), ".step", script_->state(), "format"));
  QVERIFY(refused(at("out"), ".stl", CaseState(), "labels: there is none yet"));
  QVERIFY(refused(at("labels.seg.nrrd"), ".stl", script_->state(), "is no folder"));
  QVERIFY(refused(at("labels.seg.nrrd") / "out", ".stl", script_->state(), "labels.seg.nrrd"));
  CaseState nothing;
  nothing[part::labels] = std::make_shared<const LabelMap>(LabelMap{LabelVolume(labels_.voxels.grid()), {}});
  QVERIFY(refused(at("out"), ".stl", nothing, "are empty"));
  QVERIFY(!fs::exists(at("out")));
}

void SurfaceExportTest::ACancelLeavesNothing() {
  const auto before = std::make_shared<CancelFlag>();
  before->request();
  QVERIFY(!written(at("out"), ".stl", script_->state(), RunContext({}, before, 1)));
  QVERIFY(!fs::exists(at("out")));
  // While the second is written.
  const std::vector<fs::path> was = entries(folder_->path());
  const auto cancelled = [&](const CaseState& state) {
    const auto cancel = std::make_shared<CancelFlag>();
    int files = 0;
    const auto sink = [&](double, std::string_view stage) {
      if (stage == "case.write" && ++files == 2) cancel->request();
    };
    return !written(at("out"), ".stl", state, RunContext(sink, cancel, 1)) && files == 2;
  };
  QVERIFY(cancelled(script_->state()));
  QVERIFY(entries(folder_->path()) == was);
  // Those of a former state stay. The lesion makes the liver another one.
  QVERIFY(written(at("out"), ".stl", script_->state()));
  const std::string liver = read_file(at("out") / "liver.stl");
  const std::vector<fs::path> there = entries(at("out"));
  const CaseState later = with_lesions({{structure::kFirstLesion, Eigen::Vector3d(-0.055, 0.0, 0.0)}}, 0.02);
  QVERIFY(cancelled(later));
  QVERIFY(read_file(at("out") / "liver.stl") == liver);
  QVERIFY(entries(at("out")) == there);
  QVERIFY(written(at("out"), ".stl", later));
  QVERIFY(read_file(at("out") / "liver.stl") != liver);
  QVERIFY(entries(at("out")) == there);
}

void SurfaceExportTest::WhatFailsLeavesNothing() {
  const std::vector<fs::path> was = entries(folder_->path());
  CaseState state;
  const auto built = std::make_shared<model::BuiltModel>();
  std::vector<std::string> notes;
  built->model.surfaces = *model::surfaces_of_labels(labels_, RunContext(), notes);
  QCOMPARE(built->model.surfaces.size(), std::size_t{3});
  built->model.surfaces.back().mesh.vertices(0, 0) = std::numeric_limits<double>::quiet_NaN();
  state[part::model] = built;
  QVERIFY_THROWS_EXCEPTION(Error, written(at("out"), ".stl", state));
  QVERIFY(entries(folder_->path()) == was);
  // A file cannot go where a folder is.
  fs::create_directories(at("out") / "portal_vein.stl");
  QVERIFY_THROWS_EXCEPTION(FileError, written(at("out"), ".stl", script_->state()));
  QCOMPARE(entries(at("out")).size(), std::size_t{1});
}

QTEST_APPLESS_MAIN(SurfaceExportTest)
#include "surface_export_test.moc"
