// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "glisson/core/files.h"
#include "glisson/ui/shell/case_opening.h"

namespace glisson {

class CaseOpeningTest : public QObject {
  Q_OBJECT
 private slots:
  void PathsAreTakenForWhatTheyAre();
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
  QCOMPARE(code("ct.NII.gz"), std::string("import_image"));
  QCOMPARE(code("liver.seg.nrrd"), std::string("import_labels"));
  QCOMPARE(code("scope.yaml"), std::string("set_calibration"));
  QCOMPARE(code("film.mkv"), std::string("set_video"));
  QCOMPARE(code("letter.pdf"), std::string());
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::CaseOpeningTest)
#include "case_opening_test.moc"
