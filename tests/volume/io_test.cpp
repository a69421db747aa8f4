// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/volume/io.h"
#include "data_folder.h"

#include <QTest>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "phantom.h"

using namespace glisson;
namespace fs = std::filesystem;

namespace {

Image read(const fs::path& path) { return read_image(path, RunContext()).value(); }

LabelVolume label_phantom() {
  const Image image = test::stored_world(0b010'011);
  std::vector<Label> values;
  for (const std::int16_t value : *image.voxels) values.push_back(static_cast<Label>((value + 1000) % 23));
  return LabelVolume(image.grid, values);
}

/// A NRRD file by hand: `fields` after the size of a 2 x 2 x 2 volume of bytes 1..8.
fs::path hand_made_nrrd(const fs::path& folder, const std::string& fields) {
  const fs::path path = folder / "hand.nrrd";
  write_file_atomically(path, "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n" + fields +
                                  "\n\n" + std::string("\1\2\3\4\5\6\7\10"));
  return path;
}

}  // namespace

class IoTest : public QObject {
  Q_OBJECT
 private slots:
  void EveryOrientationShowsTheSamePatient_data();
  void EveryOrientationShowsTheSamePatient();
  void ObliqueGridsComeBack();
  void RightAnteriorSuperiorBecomesLeftPosteriorSuperior();
  void HounsfieldUnitsAndModalityComeBack();
  void LabelsComeBackFromEveryFormat_data();
  void LabelsComeBackFromEveryFormat();
  void SegmentsKeepNamesColoursAndTerminology();
  void CancelledReadingGivesNothing();
  void GridsThatDifferAreRefused();
  void RealSeriesAndItsLabelsLieOnOneGrid();
};

void IoTest::EveryOrientationShowsTheSamePatient_data() {
  QTest::addColumn<QString>("extension");
  QTest::addColumn<int>("step");
  QTest::newRow("nrrd") << ".nrrd" << 1;
  QTest::newRow("nii.gz") << ".nii.gz" << 1;
  QTest::newRow("mha") << ".mha" << 5;
}

void IoTest::EveryOrientationShowsTheSamePatient() {
  QFETCH(QString, extension);
  QFETCH(int, step);
  const TemporaryFolder folder;
  for (int orientation = 0; orientation < 48; orientation += step) {
    const Image image = test::stored_world(orientation);
    QVERIFY(test::shows_world(image));
    const fs::path path = folder.path() / ("world" + extension.toStdString());
    write_image(path, image);
    const Image back = read(path);
    QVERIFY2(test::shows_world(back), qPrintable(QString("orientation %1").arg(orientation)));
    QCOMPARE(back.grid.size, image.grid.size);
  }
}

void IoTest::ObliqueGridsComeBack() {
  const TemporaryFolder folder;
  std::mt19937 random(4);
  for (int n = 0; n < 3; ++n) {
    Image image = test::stored_world(n * 9);
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.3 + n, Eigen::Vector3d(1, 2 - n, 3).normalized()));
    image.grid.direction = turn.toRotationMatrix() * image.grid.direction;
    for (const char* name : {"a.nrrd", "a.nii.gz", "a.nii", "a.mha"}) {
      write_image(folder.path() / name, image);
      const Image back = read(folder.path() / name);
      QVERIFY2(back.grid.same_as(image.grid), name);
      QCOMPARE(*back.voxels, *image.voxels);
    }
  }
}

void IoTest::RightAnteriorSuperiorBecomesLeftPosteriorSuperior() {
  const TemporaryFolder folder;
  const Image image = read(hand_made_nrrd(
      folder.path(),
      "space: right-anterior-superior\nspace directions: (2,0,0) (0,3,0) (0,0,4)\nspace origin: (10,20,30)"));
  QCOMPARE(image.grid.origin_mm, Eigen::Vector3d(-10, -20, 30));
  QVERIFY(image.grid.direction.isApprox(Eigen::Vector3d(-1, -1, 1).asDiagonal().toDenseMatrix()));
  QCOMPARE(image.grid.spacing_mm, Eigen::Vector3d(2, 3, 4));
  QCOMPARE(int(image.at({1, 0, 0})), 2);
  QCOMPARE(int(image.at({0, 0, 1})), 5);
}

void IoTest::HounsfieldUnitsAndModalityComeBack() {
  const TemporaryFolder folder;
  Image image = test::stored_world(0);
  auto values = *image.voxels;
  values[0] = -32768;
  values[1] = 32767;
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(values);
  image.modality = Modality::mr;
  image.description = "T1 \\ late\nphase";
  write_image(folder.path() / "a.nrrd", image);
  const Image back = read(folder.path() / "a.nrrd");
  QCOMPARE(*back.voxels, values);
  QCOMPARE(back.modality, Modality::mr);
  write_image(folder.path() / "a.mha", image);  // says nothing of modality: HU go below zero
  QCOMPARE(read(folder.path() / "a.mha").modality, Modality::ct);
}

void IoTest::LabelsComeBackFromEveryFormat_data() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"a.seg.nrrd", "a.nrrd", "a.nii.gz", "a.mha"}) QTest::newRow(name) << name;
}

void IoTest::LabelsComeBackFromEveryFormat() {
  QFETCH(QString, name);
  const TemporaryFolder folder;
  LabelVolume labels = label_phantom();
  write_labels(folder.path() / name.toStdString(), labels, {});
  QVERIFY(read_labels(folder.path() / name.toStdString()).voxels == labels);
  labels.set({0, 0, 0}, 40000);  // more than a byte
  write_labels(folder.path() / name.toStdString(), labels, {});
  const LabelFile file = read_labels(folder.path() / name.toStdString());
  QVERIFY(file.voxels == labels);
  QCOMPARE(file.infos.size(), std::size_t(23));
  QCOMPARE(file.infos.back().code, Label(40000));
}

void IoTest::SegmentsKeepNamesColoursAndTerminology() {
  const TemporaryFolder folder;
  LabelVolume labels(label_phantom().grid());
  labels.set({1, 1, 1}, 3);
  labels.set({2, 1, 1}, 16);
  const std::string term = "Segmentation category~SCT^85756007^Tissue~SCT^10200004^Liver~^^~^^~^^";
  write_labels(folder.path() / "a.seg.nrrd", labels,
               {{16, "lesion \\ one", term, {0.25, 0.5, 1.0}}, {7, "absent", "", {0, 0, 0}}});
  const LabelFile file = read_labels(folder.path() / "a.seg.nrrd");
  QCOMPARE(file.infos.size(), std::size_t(2));
  QCOMPARE(file.infos[0].code, Label(3));
  QCOMPARE(file.infos[1].code, Label(16));
  QCOMPARE(file.infos[1].name, std::string("lesion \\ one"));
  QCOMPARE(file.infos[1].terminology, term);
  QCOMPARE(file.infos[1].colour[0], 0.25);
  QVERIFY(file.voxels == labels);
}

void IoTest::CancelledReadingGivesNothing() {
  const TemporaryFolder folder;
  write_image(folder.path() / "a.nrrd", test::stored_world(0));
  const auto flag = std::make_shared<CancelFlag>();
  flag->request();
  QVERIFY(!read_image(folder.path() / "a.nrrd", RunContext({}, flag, 1)).has_value());
}

void IoTest::GridsThatDifferAreRefused() {
  const VolumeGrid a = test::stored_world(0).grid;
  VolumeGrid b = a;
  require_same_grid(a, b, "labels");
  b.origin_mm.x() += 0.5;
  QVERIFY_THROWS_EXCEPTION(InputError, require_same_grid(a, b, "labels"));
  b = a;
  b.size.x() += 1;
  QVERIFY_THROWS_EXCEPTION(InputError, require_same_grid(a, b, "labels"));
}

void IoTest::RealSeriesAndItsLabelsLieOnOneGrid() {
  const fs::path folder = test::data_folder() / "ct_ircad1";
  if (!fs::exists(folder / "PATIENT_DICOM.tar.gz")) QSKIP("the real CT is not here (set GLISSON_DATA)");
  const Image image = read(folder / "PATIENT_DICOM.tar.gz");
  QCOMPARE(image.grid.size, Eigen::Vector3i(512, 512, 129));
  QCOMPARE(image.modality, Modality::ct);
  const LabelFile labels = read_labels(folder / "3Dircadb0101Labeled.vti");
  QCOMPARE(labels.voxels.grid().size, image.grid.size);
  // The label file has no origin; voxel by voxel it is the CT. Bone is bright, the liver is not.
  const std::vector<Label> dense = labels.voxels.dense();
  double bone = 0.0, liver = 0.0;
  long bones = 0, livers = 0;
  for (std::size_t i = 0; i < dense.size(); ++i) {
    if (dense[i] == 65) bone += (*image.voxels)[i], ++bones;
    if (dense[i] == 449) liver += (*image.voxels)[i], ++livers;
  }
  QVERIFY(bones > 100000 && livers > 100000);
  QVERIFY2(bone / static_cast<double>(bones) > 180.0, qPrintable(QString::number(bone / bones)));
  const double mean = liver / static_cast<double>(livers);
  QVERIFY2(mean > 80.0 && mean < 150.0, qPrintable(QString::number(mean)));
}

QTEST_APPLESS_MAIN(IoTest)
#include "io_test.moc"
