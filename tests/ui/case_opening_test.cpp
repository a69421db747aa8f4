// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "glisson/core/files.h"
#include "glisson/engine/commands/import_cloud.h"
#include "glisson/engine/commands/import_mesh.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/ui/shell/case_opening.h"

namespace glisson {

class CaseOpeningTest : public QObject {
  Q_OBJECT
 private slots:
  void PathsAreTakenForWhatTheyAre();
  void WhatSaysNoUnitIsTakenInTheOneThatIsTold();
};

void CaseOpeningTest::PathsAreTakenForWhatTheyAre() {
  const auto code = [](const std::filesystem::path& path) {
    const auto opening = ui::opening_of(path);
    return opening ? std::string(opening->command.code()) : std::string();
  };
  const TemporaryFolder folder;
  const std::filesystem::path root = folder.path();
  std::filesystem::create_directories(root / "dicom");
  std::filesystem::create_directories(root / "a.glisson");
  std::filesystem::create_directories(root / "surfaces");
  write_file_atomically(root / "surfaces" / "liver.vtk", std::string("x"));
  std::filesystem::create_directories(root / "renamed");
  write_file_atomically(root / "renamed" / "case.json", std::string("{}"));
  QCOMPARE(code(root / "dicom"), std::string("import_image"));
  QCOMPARE(code(root / "renamed"), std::string("open_case"));
  QCOMPARE(code(root / "a.glisson"), std::string("open_case"));
  QCOMPARE(code((root / "a.glisson").string() + "/"), std::string("open_case"));
  QCOMPARE(code(root / "surfaces"), std::string("import_surfaces"));
  // A legacy .vtk by what is in it.
  TetMesh tetrahedron;
  tetrahedron.vertices.resize(4, 3);
  tetrahedron.vertices << 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1;
  tetrahedron.tetrahedra.resize(1, 4);
  tetrahedron.tetrahedra << 0, 1, 2, 3;
  write_tet_mesh(root / "volume.vtk", tetrahedron, LengthUnit::millimetre);
  write_triangle_mesh(root / "skin.vtk", boundary_surface(tetrahedron).mesh, LengthUnit::millimetre);
  QCOMPARE(code(root / "volume.vtk"), std::string("import_mesh"));
  QCOMPARE(code(root / "skin.vtk"), std::string("import_surfaces"));
  QCOMPARE(code(root / "gone.vtk"), std::string("import_surfaces"));
  QCOMPARE(code("mesh.vtu"), std::string("import_mesh"));
  QCOMPARE(code("ct.NII.gz"), std::string("import_image"));
  for (const char* medium : {"disc.zip", "DISC.ZIP", "a.tar", "a.tar.gz", "DICOMDIR", "disc/dicomdir"})
    QCOMPARE(code(medium), std::string("import_image"));
  QCOMPARE(code("liver.seg.nrrd"), std::string("import_labels"));
  QCOMPARE(code("liver.dcm"), std::string("import_labels"));
  QCOMPARE(code("scope.yaml"), std::string("set_calibration"));
  QCOMPARE(code("film.mkv"), std::string("set_video"));
  QCOMPARE(code("letter.pdf"), std::string());
}

void CaseOpeningTest::WhatSaysNoUnitIsTakenInTheOneThatIsTold() {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "surfaces");
  write_file_atomically(folder.path() / "surfaces" / "liver.stl", std::string("x"));
  const auto told = [](const std::filesystem::path& path) {
    const auto opening = ui::opening_of(path);
    return opening && opening->way == ui::Opening::Way::in_a_unit ? opening->in(LengthUnit::centimetre)
                                                                  : engine::Command(engine::OpenCase{});
  };
  const engine::Command mesh = told("mesh.vtu"), surface = told("liver.stl"), cloud = told("cloud.ply"),
                        several = told(folder.path() / "surfaces");
  QCOMPARE(mesh.as<engine::ImportMesh>()->unit, LengthUnit::centimetre);
  QCOMPARE(surface.as<engine::ImportSurfaces>()->unit, LengthUnit::centimetre);
  QCOMPARE(several.as<engine::ImportSurfaces>()->unit, LengthUnit::centimetre);
  QCOMPARE(cloud.as<engine::ImportCloud>()->unit, LengthUnit::centimetre);
  QVERIFY(ui::opening_of("scope.yaml")->way == ui::Opening::Way::plain);  // says it
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::CaseOpeningTest)
#include "case_opening_test.moc"
