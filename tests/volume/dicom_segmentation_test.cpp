// SPDX-License-Identifier: GPL-3.0-or-later
// Written by DCMTK, read by GDCM: in the reading program, and here by itself.
#include <gdcmReader.h>
#include <gdcmSequenceOfItems.h>

#include <Eigen/Geometry>
#include <QTest>
#include <cstring>
#include <random>

#include "dicom_bytes.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/dicom_segmentation.h"

using namespace glisson;
using glisson::test::HandSlice;
namespace fs = std::filesystem;

namespace {

constexpr const char* kLesion =
    "Segmentation category and type - DICOM master list~SCT^49755003^Morphologically Altered Structure~"
    "SCT^52988006^Lesion~^^~Anatomic codes - DICOM master list~SCT^10200004^Liver~^^";

/// Blobs without symmetry that leave the first slice and one in the middle empty.
LabelVolume phantom(const VolumeGrid& grid) {
  LabelVolume labels(grid);
  std::mt19937 random(7);
  for (int k = 1; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        if (k == grid.size.z() / 2) continue;
        const auto draw = random() % 5;
        labels.set({i, j, k}, draw == 0   ? Label{1}
                              : draw == 1 ? Label{16}
                              : draw == 2 ? Label{40000}
                                          : Label{0});
      }
  return labels;
}

VolumeGrid oblique_grid(bool left_handed) {
  VolumeGrid grid;
  grid.size = {13, 9, 8};  // no multiple of eight bits a frame
  grid.spacing_mm = {0.7123456789, 0.83, 2.5};
  grid.origin_mm = {-120.3, 45.123456789, -1010.5};
  grid.direction = Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized())).matrix();
  if (left_handed) grid.direction.col(2) *= -1.0;
  return grid;
}

std::string text_at(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  if (!data.FindDataElement(tag)) return "";
  const gdcm::ByteValue* bytes = data.GetDataElement(tag).GetByteValue();
  if (bytes == nullptr) return "";
  std::string text(bytes->GetPointer(), bytes->GetLength());
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
  return text;
}

/// The n-th item, from 1, of a sequence. The file must live on.
const gdcm::DataSet& item_of(const gdcm::DataSet& data, const gdcm::Tag& tag, std::size_t n = 1) {
  static std::vector<gdcm::SmartPointer<gdcm::SequenceOfItems>> alive;
  alive.push_back(data.GetDataElement(tag).GetValueAsSQ());
  return alive.back()->GetItem(n).GetNestedDataSet();
}

QString refusal_of(const fs::path& path) {
  try {
    (void)read_labels(path);
  } catch (const InputError& error) {
    return QString::fromStdString(error.what());
  }
  return "";
}

}  // namespace

class DicomSegmentationTest : public QObject {
  Q_OBJECT
 private slots:
  void init() { folder_ = std::make_unique<TemporaryFolder>(); }
  void LabelsComeBackToTheVoxel_data();
  void LabelsComeBackToTheVoxel();
  void NamesMeaningColourAndStateComeBack();
  void AnotherReaderFindsPlacesBitsAndReferences();
  void AnotherGridIsNotTakenForTheSame();
  void SlicesOfARoundedCtFindTheirPlace();
  void ASingleSliceFindsItsPlaceWhateverItsThickness();
  void SeriesSayWhoseTheyAre();
  void SlicesOfTwoPatientsAreRefused();
  void OtherObjectsAreRefused();
  void AFrameThatLiesOnAnotherIsRefused();
  void DamagedFilesAreRefusedOrRead();
  void NoLabelsAreNotWritten();

 private:
  fs::path at(const char* name) const { return folder_->path() / name; }
  std::unique_ptr<TemporaryFolder> folder_;
};

void DicomSegmentationTest::LabelsComeBackToTheVoxel_data() {
  QTest::addColumn<bool>("left_handed");
  QTest::newRow("right-handed") << false;
  QTest::newRow("left-handed") << true;
}

void DicomSegmentationTest::LabelsComeBackToTheVoxel() {
  QFETCH(bool, left_handed);
  const VolumeGrid grid = oblique_grid(left_handed);
  const LabelVolume labels = phantom(grid);
  write_dicom_labels(at("a.dcm"), labels, {}, {});
  const DicomLabels back = *read_dicom_labels(at("a.dcm"), RunContext());
  const auto cancel = std::make_shared<CancelFlag>();
  cancel->request();
  QVERIFY(!read_dicom_labels(at("a.dcm"), RunContext({}, cancel, 1)));
  QVERIFY(back.own);
  QCOMPARE(back.file.voxels.grid().size.z(), grid.size.z() - 1);  // its first slice is empty
  const auto placed = placed_on(back.file.voxels, grid);
  QVERIFY(placed.has_value());
  QVERIFY(*placed == labels);
  // Whatever it is called.
  fs::rename(at("a.dcm"), at("IM0001"));
  QVERIFY(read_labels(at("IM0001")).voxels == back.file.voxels);
}

void DicomSegmentationTest::NamesMeaningColourAndStateComeBack() {
  const LabelInfo lesion{16, "lesion_1", kLesion, {0.8, 0.4, 0.0}, "completed"};
  const LabelInfo odd{40000, "Z\xc3\xbcrich", "", {0.0, 0.45, 0.7}, ""};
  write_dicom_labels(at("a.dcm"), phantom(oblique_grid(false)), {odd, lesion}, {});
  const std::vector<LabelInfo> infos = read_labels(at("a.dcm")).infos;
  QCOMPARE(infos.size(), std::size_t{3});
  QCOMPARE(infos[0].name, std::string("label_1"));
  QCOMPARE(infos[1].code, Label{16});
  QCOMPARE(infos[1].name, lesion.name);
  QCOMPARE(infos[1].terminology, lesion.terminology);
  QCOMPARE(infos[1].status, lesion.status);
  QCOMPARE(infos[2].code, Label{40000});
  QCOMPARE(infos[2].name, odd.name);
  for (std::size_t c = 0; c < 3; ++c) {
    QVERIFY(std::abs(infos[1].colour[c] - lesion.colour[c]) < 2e-3);
    QVERIFY(std::abs(infos[2].colour[c] - odd.colour[c]) < 2e-3);
  }
}

void DicomSegmentationTest::AnotherReaderFindsPlacesBitsAndReferences() {
  const VolumeGrid grid = oblique_grid(false);
  const LabelVolume labels = phantom(grid);
  DicomSource source{
      "Doe Jane", "4711", "1960-01-31", "1.2.3.4", "1.2.3.5", "1.2.3.6", "1.2.840.10008.5.1.4.1.1.2", {}};
  for (int k = 0; k < grid.size.z(); ++k) source.slice_uids.push_back("1.2.3.7." + std::to_string(k + 1));
  write_dicom_labels(at("a.dcm"), labels, {}, source);
  gdcm::Reader reader;
  reader.SetFileName(at("a.dcm").c_str());
  QVERIFY(reader.Read());
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();
  QCOMPARE(text_at(data, {0x0008, 0x0016}), std::string("1.2.840.10008.5.1.4.1.1.66.4"));
  QCOMPARE(text_at(data, {0x0008, 0x0060}), std::string("SEG"));
  QCOMPARE(text_at(data, {0x0062, 0x0001}), std::string("BINARY"));
  QCOMPARE(text_at(data, {0x0020, 0x000d}), source.study_uid);
  QCOMPARE(text_at(data, {0x0020, 0x0052}), source.frame_of_reference_uid);
  // Whose it is stays out.
  const std::string bytes = read_file(at("a.dcm"));
  for (const char* word : {"Doe", "4711", "1960"}) QVERIFY(bytes.find(word) == std::string::npos);
  const gdcm::DataSet& series = item_of(data, {0x0008, 0x1115});
  QCOMPARE(text_at(series, {0x0020, 0x000e}), source.series_uid);

  const long count = static_cast<long>(grid.size.x()) * grid.size.y();
  const std::string pixels(data.GetDataElement(gdcm::Tag(0x7fe0, 0x0010)).GetByteValue()->GetPointer(),
                           data.GetDataElement(gdcm::Tag(0x7fe0, 0x0010)).GetByteValue()->GetLength());
  const int frames = std::stoi(text_at(data, {0x0028, 0x0008}));
  QCOMPARE(frames, 3 * (grid.size.z() - 2));
  const Label codes[] = {1, 16, 40000};
  for (int frame = 0; frame < frames; ++frame) {
    const gdcm::DataSet& groups = item_of(data, {0x5200, 0x9230}, static_cast<std::size_t>(frame + 1));
    std::istringstream place(text_at(item_of(groups, {0x0020, 0x9113}), {0x0020, 0x0032}));
    Eigen::Vector3d p;
    char between = 0;
    place >> p.x() >> between >> p.y() >> between >> p.z();
    const Eigen::Vector3d index = grid.index_of(Point<CtFrame>(1e-3 * p));
    const int k = static_cast<int>(std::lround(index.z()));
    QVERIFY((index - Eigen::Vector3d(0, 0, k)).norm() < 1e-6);
    const gdcm::DataSet& image = item_of(item_of(groups, {0x0008, 0x9124}), {0x0008, 0x2112});
    QCOMPARE(text_at(image, {0x0008, 0x1155}), source.slice_uids[static_cast<std::size_t>(k)]);
    std::uint16_t segment = 0;
    std::memcpy(&segment,
                item_of(groups, {0x0062, 0x000a})
                    .GetDataElement(gdcm::Tag(0x0062, 0x000b))
                    .GetByteValue()
                    ->GetPointer(),
                sizeof(segment));
    for (long n = 0; n < count; ++n) {
      const auto bit = static_cast<std::size_t>(frame * count + n);
      const bool set = ((static_cast<unsigned char>(pixels[bit / 8]) >> (bit % 8)) & 1U) != 0;
      const Eigen::Vector3i voxel(static_cast<int>(n % grid.size.x()), static_cast<int>(n / grid.size.x()),
                                  k);
      QCOMPARE(set, labels.at(voxel) == codes[segment - 1]);
    }
  }
}

void DicomSegmentationTest::AnotherGridIsNotTakenForTheSame() {
  const VolumeGrid grid = oblique_grid(false);
  const LabelVolume labels = phantom(grid);
  QVERIFY(placed_on(labels, grid).value() == labels);
  VolumeGrid other = grid;
  other.origin_mm.x() += 0.1;
  QVERIFY(!placed_on(labels, other));
  other = grid;
  other.spacing_mm.z() *= 1.1;
  QVERIFY(!placed_on(labels, other));
  other = grid;
  other.size.x() -= 1;  // the labels reach beyond it
  QVERIFY(!placed_on(labels, other));
  other = grid;
  other.direction = Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX()).matrix() * other.direction;
  QVERIFY(!placed_on(labels, other));
}

void DicomSegmentationTest::SlicesOfARoundedCtFindTheirPlace() {
  const VolumeGrid grid = oblique_grid(false);
  const LabelVolume labels = phantom(grid);
  // A part of its slices, whose positions are not quite those of the even grid.
  constexpr int kFirst = 2, kCount = 4;
  const auto drawn = [&](const Eigen::Vector3d& off, double off_last) {
    VolumeGrid part = grid;
    part.size.z() = kCount;
    part.origin_mm += grid.direction * (Eigen::Vector3d(0, 0, kFirst) + off).cwiseProduct(grid.spacing_mm);
    part.spacing_mm.z() *= 1.0 + (off_last - off.z()) / (kCount - 1);
    LabelVolume cut(part);
    for (int k = 0; k < kCount; ++k)
      for (int j = 0; j < grid.size.y(); ++j)
        for (int i = 0; i < grid.size.x(); ++i) cut.set({i, j, k}, labels.at({i, j, kFirst + k}));
    return cut;
  };
  LabelVolume expected(grid);
  for (int k = kFirst; k < kFirst + kCount; ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) expected.set({i, j, k}, labels.at({i, j, k}));
  for (const auto& [off, off_last] : {std::pair(0.07, 0.07), {-0.07, -0.07}, {0.07, -0.07}, {0.0, 0.07}}) {
    const auto placed = placed_on(drawn({0, 0, off}, off_last), grid);
    QVERIFY2(placed && *placed == expected, qPrintable(QString("%1 %2").arg(off).arg(off_last)));
  }
  QVERIFY(!placed_on(drawn({0, 0, 0.5}, 0.5), grid));
  QVERIFY(!placed_on(drawn({0, 0, 0.0}, 0.5), grid));
  QVERIFY(!placed_on(drawn({0.07, 0, 0}, 0.0), grid));
  QVERIFY(!placed_on(drawn({0, 0.07, 0}, 0.0), grid));
}

/// Where a file of one slice says no spacing between slices, its thickness stands for it: slices of a CT
/// mostly overlap.
void DicomSegmentationTest::ASingleSliceFindsItsPlaceWhateverItsThickness() {
  const VolumeGrid grid = oblique_grid(false);
  const LabelVolume labels = phantom(grid);
  constexpr int kSlice = 3;
  LabelVolume expected(grid);
  for (int j = 0; j < grid.size.y(); ++j)
    for (int i = 0; i < grid.size.x(); ++i) expected.set({i, j, kSlice}, labels.at({i, j, kSlice}));
  const auto drawn = [&](double thickness, const Eigen::Vector3d& off) {
    VolumeGrid slice = grid;
    slice.size.z() = 1;
    slice.origin_mm += grid.direction * (Eigen::Vector3d(0, 0, kSlice) + off).cwiseProduct(grid.spacing_mm);
    slice.spacing_mm.z() *= thickness;
    LabelVolume cut(slice);
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) cut.set({i, j, 0}, labels.at({i, j, kSlice}));
    return cut;
  };
  for (const double thickness : {0.4, 1.0, 1.6, 2.0, 5.0}) {
    const auto placed = placed_on(drawn(thickness, {0, 0, 0}), grid);
    QVERIFY2(placed && *placed == expected, qPrintable(QString::number(thickness)));
  }
  QVERIFY(!placed_on(drawn(2.0, {0, 0, 0.5}), grid));
  QVERIFY(!placed_on(drawn(2.0, {0.07, 0, 0}), grid));
}

void DicomSegmentationTest::SeriesSayWhoseTheyAre() {
  for (int k = 0; k < 4; ++k) {
    HandSlice slice;
    slice.other = {{"0010|0010", "Doe^Jane"},
                   {"0010|0020", "4711"},
                   {"0010|0030", "19600131"},
                   {"0020|0052", "1.2.3.6"}};
    write_file_atomically(folder_->path() / std::to_string(9 - k), test::dicom_of(k, slice));
  }
  const Scan scan = read_scan(folder_->path(), RunContext()).value();
  QCOMPARE(scan.source.patient, std::string("Doe Jane"));
  QCOMPARE(scan.source.patient_id, std::string("4711"));
  QCOMPARE(scan.source.birth_date, std::string("1960-01-31"));
  QCOMPARE(scan.source.frame_of_reference_uid, std::string("1.2.3.6"));
  QCOMPARE(scan.source.slice_uids.size(), std::size_t{4});
  QCOMPARE(scan.source.slice_uids.back(), HandSlice().series + ".9.4");  // in the order of the slices
  write_image(at("a.nrrd"), scan.image);
  QVERIFY(read_scan(at("a.nrrd"), RunContext())->source.empty());
}

void DicomSegmentationTest::SlicesOfTwoPatientsAreRefused() {
  for (int k = 0; k < 4; ++k) {
    HandSlice slice;
    slice.other = {{"0010|0020", k == 2 ? "4712" : "4711"}};
    write_file_atomically(folder_->path() / std::to_string(k), test::dicom_of(k, slice));
  }
  try {
    (void)read_image(folder_->path(), RunContext());
    QFAIL("is read");
  } catch (const InputError& error) {
    QVERIFY2(error.problem().find("another patient") != std::string::npos, error.what());
  }
}

void DicomSegmentationTest::OtherObjectsAreRefused() {
  write_file_atomically(at("slice.dcm"), test::dicom_of(0, {}));
  QVERIFY(refusal_of(at("slice.dcm")).contains("SOPClassUID (0008|0016)"));
  write_file_atomically(at("letter.dcm"), "Dear colleague, ");
  QVERIFY(refusal_of(at("letter.dcm")).contains("is named as DICOM, but is none"));
  write_dicom_labels(at("a.dcm"), phantom(oblique_grid(false)), {}, {});
  std::string bytes = read_file(at("a.dcm"));
  const std::size_t kind = bytes.find("BINARY");
  QVERIFY(kind != std::string::npos);
  write_file_atomically(at("b.dcm"), bytes.replace(kind, 6, "SHADES"));
  QVERIFY(refusal_of(at("b.dcm")).contains("SegmentationType (0062|0001)"));
}

/// One digit of its place is enough: its slice would be empty, and the other one would be painted over.
void DicomSegmentationTest::AFrameThatLiesOnAnotherIsRefused() {
  VolumeGrid grid;
  grid.size = {4, 3, 3};
  grid.spacing_mm = {2.0, 2.0, 2.0};
  grid.origin_mm = {0.0, 0.0, 10.0};
  write_dicom_labels(at("a.dcm"), LabelVolume(grid, std::vector<Label>(36, Label{1})), {}, {});
  QCOMPARE(refusal_of(at("a.dcm")), QString());
  std::string bytes = read_file(at("a.dcm"));
  const std::size_t second = bytes.find("0\\0\\12");
  QVERIFY(second != std::string::npos);
  bytes[second + 5] = '0';
  write_file_atomically(at("b.dcm"), bytes);
  QVERIFY2(refusal_of(at("b.dcm")).contains("twice in one slice"), qPrintable(refusal_of(at("b.dcm"))));
}

void DicomSegmentationTest::DamagedFilesAreRefusedOrRead() {
  write_dicom_labels(at("a.dcm"), phantom(oblique_grid(false)), {}, {});
  const std::string bytes = read_file(at("a.dcm"));
  write_file_atomically(at("b.dcm"), bytes.substr(0, bytes.size() - 40));
  QVERIFY(!refusal_of(at("b.dcm")).isEmpty());
  std::mt19937 random(5);
  for (int n = 0; n < 40; ++n) {
    std::string damaged = bytes;
    for (int m = 0; m < 3; ++m)
      damaged[140 + random() % (damaged.size() - 140)] = static_cast<char>(random() % 256);
    write_file_atomically(at("b.dcm"), damaged);
    (void)refusal_of(at("b.dcm"));  // any other error is a failure
  }
}

void DicomSegmentationTest::NoLabelsAreNotWritten() {
  QVERIFY_THROWS_EXCEPTION(InputError,
                           write_dicom_labels(at("a.dcm"), LabelVolume(oblique_grid(false)), {}, {}));
  QVERIFY(!fs::exists(at("a.dcm")));
}

QTEST_APPLESS_MAIN(DicomSegmentationTest)
#include "dicom_segmentation_test.moc"
