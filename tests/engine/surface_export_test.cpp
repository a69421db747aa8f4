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
#include <QtTest>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/export_surfaces.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/script.h"
#include "glisson/engine/surface_export.h"
#include "glisson/model/build.h"
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

}  // namespace

class SurfaceExportTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void EachFormatHoldsEachStructureWhereItIs_data();
  void EachFormatHoldsEachStructureWhereItIs();
  void NothingSaysWhoseTheyAre();
  void WhatIsWrittenComesInAgain();
  void SurfacesOfSomebodyElseAreNotMixedWithThem();
  void WhatCannotBeWrittenIsRefused();
  void ACancelLeavesNothing();

 private:
  fs::path at(const char* name) const { return folder_->path() / name; }
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
    const auto files =
        write_case_surfaces(at("out") / ending.substr(1), ending, script_->state(), RunContext());
    QVERIFY(files && files->size() == 3);
    for (const fs::path& file : *files)
      for (const char* word : {"Doe^Jane", "4711-x", "1960-01-31", "labels.seg"})
        QVERIFY2(read_file(file).find(word) == std::string::npos, file.c_str());
  }
}

void SurfaceExportTest::WhatIsWrittenComesInAgain() {
  for (const std::string& ending : surface_endings()) {
    const fs::path out = at("again") / ending.substr(1);
    script_->run(ExportSurfaces{out, ending});
    script_->run(ExportSurfaces{out, ending});  // over itself
    const model::SurfaceSet set = model::read_surfaces(out, LengthUnit::millimetre);
    QVERIFY(set.notes.empty());
    QCOMPARE(set.others.size(), std::size_t{2});
    QVERIFY(std::any_of(set.others.begin(), set.others.end(),
                        [](const NamedSurface& s) { return s.structure == structure::kFirstLesion; }));
  }
}

void SurfaceExportTest::SurfacesOfSomebodyElseAreNotMixedWithThem() {
  fs::create_directories(at("out"));
  write_file_atomically(at("out") / "lesion_9.obj", std::string("v 0 0 0\n"));
  try {
    write_case_surfaces(at("out"), ".stl", script_->state(), RunContext());
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
      write_case_surfaces(folder, ending, state, RunContext());
    } catch (const std::exception& error) {
      return std::string(error.what()).find(mentions) != std::string::npos;
    }
    return false;
  };
  QVERIFY(refused(at("out"), ".step", script_->state(), "format"));
  QVERIFY(refused(at("out"), ".stl", CaseState(), "neither labels nor a model"));
  QVERIFY(refused(at("labels.seg.nrrd"), ".stl", script_->state(), "is no folder"));
  QVERIFY(refused(at("labels.seg.nrrd") / "out", ".stl", script_->state(), "out"));
  QVERIFY(!fs::exists(at("out")));
}

void SurfaceExportTest::ACancelLeavesNothing() {
  const auto cancel = std::make_shared<CancelFlag>();
  cancel->request();
  QVERIFY(!write_case_surfaces(at("out"), ".stl", script_->state(), RunContext({}, cancel, 1)));
  QVERIFY(!fs::exists(at("out")));
}

QTEST_APPLESS_MAIN(SurfaceExportTest)
#include "surface_export_test.moc"
