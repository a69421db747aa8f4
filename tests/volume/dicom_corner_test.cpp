// SPDX-License-Identifier: GPL-3.0-or-later
#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>

#include <QTest>
#include <functional>

#include "dicom_bytes.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/io.h"
#include "glisson/volume/series.h"

using namespace glisson;
using glisson::test::HandSlice;
namespace fs = std::filesystem;

namespace {

constexpr int kSlices = 4;

/// A series; `change` makes slice k what it shall be.
void write_series(
    const fs::path& folder, const HandSlice& like = {},
    const std::function<void(int, HandSlice&)>& change = [](int, HandSlice&) {}) {
  for (int k = 0; k < kSlices; ++k) {
    HandSlice slice = like;
    slice.instance = k + 1;
    change(k, slice);
    write_file_atomically(folder / (like.series + "_" + std::to_string((k * 7 + 3) % 11)),
                          test::dicom_of(k, slice));
  }
}

QString refusal_of(const fs::path& path, const std::string& series = {}) {
  try {
    (void)read_image(path, RunContext(), series);
  } catch (const InputError& error) {
    return QString::fromStdString(error.what());
  }
  return "";
}

Image image_in(const fs::path& path, const std::string& series = {}) {
  return read_image(path, RunContext(), series).value();
}

/// Writes a slice again in another transfer syntax. False when GDCM cannot.
bool recode(const fs::path& path, gdcm::TransferSyntax::TSType syntax) {
  gdcm::ImageReader reader;
  reader.SetFileName(path.c_str());
  if (!reader.Read()) return false;
  gdcm::ImageChangeTransferSyntax change;
  change.SetTransferSyntax(gdcm::TransferSyntax(syntax));
  change.SetInput(reader.GetImage());
  if (!change.Change()) return false;
  gdcm::ImageWriter writer;
  writer.SetFileName(path.c_str());
  writer.SetFile(reader.GetFile());
  writer.SetImage(change.GetOutput());
  return writer.Write();
}

}  // namespace

class DicomCornerTest : public QObject {
  Q_OBJECT
 private slots:
  void FileNamesAndInstanceNumbersDoNotMatter();
  void SlopeAndInterceptMayChangeBySliceInMr();
  void SignedPixelsKeepTheirSign();
  void RubbishAboveTheStoredBitsIsIgnored();
  void MonochromeOneIsNotInverted();
  void LosslessTransferSyntaxesGiveTheSameVoxels_data();
  void LosslessTransferSyntaxesGiveTheSameVoxels();
  void LossyJpegComesCloseTo();
  void OneOfSeveralSeriesCanBeChosen();
  void ASeriesThatIsNotThereIsRefused();
  void SeriesAreListedInArchivesToo();
  void AScoutAndAColourPictureDoNotStandInTheWay();
  void AFileHasNoSeriesToChoose();
  void TheTiltOfTheGantryIsTold();
  void EachMissingTagIsTold_data();
  void EachMissingTagIsTold();
  void ReportsArePassedOver();
  void FramesAndColoursAreRefused();
  void PixelsThatAreNotThereAreRefused();
  void ACutOrDamagedCompressedSliceDoesNoHarm();
};

void DicomCornerTest::FileNamesAndInstanceNumbersDoNotMatter() {
  const TemporaryFolder folder;
  write_series(folder.path(), {}, [](int k, HandSlice& slice) { slice.instance = (3 - k) * 5 % 7; });
  QVERIFY(test::shows_world(image_in(folder.path())));
}

void DicomCornerTest::SlopeAndInterceptMayChangeBySliceInMr() {
  const TemporaryFolder folder;
  write_series(folder.path(), {}, [](int k, HandSlice& slice) {
    slice.slope = std::array{1.0, 2.0, 0.5, 2.5}[static_cast<std::size_t>(k)];
    slice.intercept = -1000.0 + k;
    slice.other["0008|0060"] = "MR";
  });
  QVERIFY(test::shows_world(image_in(folder.path())));
}

void DicomCornerTest::SignedPixelsKeepTheirSign() {
  const TemporaryFolder folder;
  HandSlice slice;
  slice.is_signed = true;
  slice.intercept = 0.0;
  write_series(folder.path(), slice);
  QVERIFY(test::shows_world(image_in(folder.path())));
}

void DicomCornerTest::RubbishAboveTheStoredBitsIsIgnored() {
  const TemporaryFolder folder;
  HandSlice slice;
  slice.stored_bits = 12;
  slice.high_bits = 0xA000;
  write_series(folder.path(), slice);
  QVERIFY(test::shows_world(image_in(folder.path())));
}

void DicomCornerTest::MonochromeOneIsNotInverted() {
  const TemporaryFolder folder;
  HandSlice slice;
  slice.photometric = "MONOCHROME1";
  write_series(folder.path(), slice);
  QVERIFY(test::shows_world(image_in(folder.path())));
}

void DicomCornerTest::LosslessTransferSyntaxesGiveTheSameVoxels_data() {
  QTest::addColumn<int>("syntax");
  using Syntax = gdcm::TransferSyntax;
  QTest::newRow("implicit") << static_cast<int>(Syntax::ImplicitVRLittleEndian);
  QTest::newRow("big endian") << static_cast<int>(Syntax::ExplicitVRBigEndian);
  QTest::newRow("RLE") << static_cast<int>(Syntax::RLELossless);
  QTest::newRow("JPEG lossless, process 14") << static_cast<int>(Syntax::JPEGLosslessProcess14);
  QTest::newRow("JPEG lossless, first order") << static_cast<int>(Syntax::JPEGLosslessProcess14_1);
  QTest::newRow("JPEG-LS") << static_cast<int>(Syntax::JPEGLSLossless);
  QTest::newRow("JPEG 2000") << static_cast<int>(Syntax::JPEG2000Lossless);
}

void DicomCornerTest::LosslessTransferSyntaxesGiveTheSameVoxels() {
  QFETCH(int, syntax);
  const TemporaryFolder folder;
  HandSlice slice;
  slice.zoom = 8;
  write_series(folder.path(), slice);
  const std::string plain = read_file(folder.path() / (HandSlice().series + "_3"));
  for (const auto& file : fs::directory_iterator(folder.path()))
    QVERIFY(recode(file.path(), static_cast<gdcm::TransferSyntax::TSType>(syntax)));
  QVERIFY(read_file(folder.path() / (HandSlice().series + "_3")) != plain);
  const Image image = image_in(folder.path());
  QCOMPARE(image.grid.size, Eigen::Vector3i(48, 40, 4));
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 48; ++i) QCOMPARE(image.at({i, j, k}), test::world_value({i / 8, j / 8, k}));
}

void DicomCornerTest::LossyJpegComesCloseTo() {
  const TemporaryFolder folder;
  HandSlice slice;
  slice.stored_bits = 8;
  slice.slope = 4.0;
  write_series(folder.path(), slice);
  const Image plain = image_in(folder.path());
  for (const auto& file : fs::directory_iterator(folder.path()))
    QVERIFY(recode(file.path(), gdcm::TransferSyntax::JPEGBaselineProcess1));
  const Image lossy = image_in(folder.path());
  QVERIFY(lossy.grid.same_as(plain.grid));
  for (std::size_t n = 0; n < plain.voxels->size(); ++n)
    QVERIFY2(std::abs((*lossy.voxels)[n] - (*plain.voxels)[n]) <= 6 * 4,
             qPrintable(QString::number((*lossy.voxels)[n] - (*plain.voxels)[n])));
}

void DicomCornerTest::OneOfSeveralSeriesCanBeChosen() {
  const TemporaryFolder folder;
  write_series(folder.path());
  HandSlice other;
  other.series = "1.2.3.4";
  other.number = "11";
  other.description = "arterial";
  other.shift_mm.z() = 100.0;
  write_series(folder.path(), other, [](int, HandSlice&) {});
  fs::remove(folder.path() / "1.2.3.4_2");  // the last of the other series
  const QString refusal = refusal_of(folder.path());
  for (const char* part : {"holds 2 series", "\"arterial\" with 3 slices (number 11, UID 1.2.3.4)",
                           "\"portal venous\" with 4 slices", "by its number or UID"})
    QVERIFY2(refusal.contains(part), qPrintable(refusal));
  QVERIFY(test::shows_world(image_in(folder.path(), HandSlice().series)));
  QVERIFY(test::shows_world(image_in(folder.path(), "4")));
  const Image arterial = image_in(folder.path(), "11");
  QCOMPARE(arterial.description, std::string("arterial"));
  QCOMPARE(arterial.grid.size.z(), 3);
  QCOMPARE(arterial.grid.origin_mm.z(), test::kWorldOrigin.z() + 100.0);
  const std::vector<DicomSeries> list = list_series(folder.path(), RunContext()).value();
  QCOMPARE(list.size(), std::size_t(2));
  QCOMPARE(list[0].uid, HandSlice().series);  // the likelier one
  QCOMPARE(list[1].description, std::string("arterial"));
  QCOMPARE(list[1].number, std::string("11"));
  QCOMPARE(list[1].modality, std::string("CT"));
  QCOMPARE(list[1].slices, 3);
  QCOMPARE(list[0].slices, 4);
}

void DicomCornerTest::ASeriesThatIsNotThereIsRefused() {
  const TemporaryFolder folder;
  write_series(folder.path());
  QVERIFY2(refusal_of(folder.path(), "5").contains("holds no series 5, but \"portal venous\""),
           qPrintable(refusal_of(folder.path(), "5")));
  HandSlice other;
  other.series = "1.2.3.4";  // of the same number
  write_series(folder.path(), other);
  QVERIFY(refusal_of(folder.path(), "4").contains("several series 4"));
  QVERIFY(test::shows_world(image_in(folder.path(), "1.2.3.4")));
}

void DicomCornerTest::SeriesAreListedInArchivesToo() {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "two");
  write_series(folder.path() / "two");
  HandSlice other;
  other.series = "1.2.3.4";
  write_series(folder.path() / "two", other);
  const std::string archive = (folder.path() / "two.tar.gz").string();
  QCOMPARE(std::system(("tar -czf " + archive + " -C " + folder.path().string() + " two").c_str()), 0);
  QCOMPARE(list_series(archive, RunContext()).value().size(), std::size_t(2));
  QVERIFY(test::shows_world(image_in(archive, "1.2.3.4")));
  QVERIFY_THROWS_EXCEPTION(FileError, list_series(folder.path() / "absent", RunContext()));
  const auto flag = std::make_shared<CancelFlag>();
  flag->request();
  QVERIFY(!list_series(archive, RunContext(nullptr, flag, 1)).has_value());
}

void DicomCornerTest::AScoutAndAColourPictureDoNotStandInTheWay() {
  const TemporaryFolder folder;
  write_series(folder.path());
  HandSlice scout;
  scout.series = "1.2.9";
  scout.number = "1";
  scout.other = {{"0020|0032", ""}, {"0020|0037", ""}};
  write_file_atomically(folder.path() / "scout", test::dicom_of(0, scout));
  HandSlice colour;
  colour.series = "1.2.10";
  colour.number = "99";
  colour.samples = 3;
  colour.stored_bits = 8;
  colour.photometric = "RGB";
  colour.sop_class = "1.2.840.10008.5.1.4.1.1.7";
  write_file_atomically(folder.path() / "report", test::dicom_of(0, colour));
  QVERIFY(refusal_of(folder.path()).contains("holds 3 series"));
  QVERIFY(test::shows_world(image_in(folder.path(), "4")));
  QVERIFY(refusal_of(folder.path(), "1").contains("has no tag (0020|0032)"));
  QVERIFY(refusal_of(folder.path(), "99").contains("colour picture"));
}

void DicomCornerTest::AFileHasNoSeriesToChoose() {
  const TemporaryFolder folder;
  write_image(folder.path() / "a.nrrd", test::stored_world(0));
  QVERIFY(refusal_of(folder.path() / "a.nrrd", "4").contains("cannot be chosen in a file"));
  QVERIFY_THROWS_EXCEPTION(InputError, list_series(folder.path() / "a.nrrd", RunContext()));
}

void DicomCornerTest::TheTiltOfTheGantryIsTold() {
  const TemporaryFolder folder;
  HandSlice slice;
  slice.tilt_degrees = 15.0;  // the table still moves along the patient
  write_series(folder.path(), slice);
  QVERIFY2(refusal_of(folder.path()).contains("gantry tilt of 15"), qPrintable(refusal_of(folder.path())));
}

void DicomCornerTest::EachMissingTagIsTold_data() {
  QTest::addColumn<QString>("tag");
  for (const char* tag : {"0020|0032", "0020|0037", "0028|0030"}) QTest::newRow(tag) << tag;
}

void DicomCornerTest::EachMissingTagIsTold() {
  QFETCH(QString, tag);
  const TemporaryFolder folder;
  HandSlice slice;
  slice.other[tag.toStdString()] = "";
  write_series(folder.path(), slice);
  QVERIFY2(refusal_of(folder.path()).contains("has no tag (" + tag + ")"),
           qPrintable(refusal_of(folder.path())));
}

void DicomCornerTest::ReportsArePassedOver() {
  const TemporaryFolder folder;
  write_series(folder.path());
  HandSlice report;
  report.series = "1.2.9";
  report.sop_class = "1.2.840.10008.5.1.4.1.1.88.11";
  report.other = {{"7fe0|0010", ""}};
  write_file_atomically(folder.path() / "report", test::dicom_of(0, report));
  QVERIFY(test::shows_world(image_in(folder.path())));
}

void DicomCornerTest::FramesAndColoursAreRefused() {
  const TemporaryFolder frames, colours;
  HandSlice slice;
  slice.other["0028|0008"] = "2";
  slice.sop_class = "1.2.840.10008.5.1.4.1.1.7.3";
  write_series(frames.path(), slice);
  QVERIFY(!refusal_of(frames.path()).isEmpty());
  HandSlice colour;
  colour.samples = 3;
  colour.stored_bits = 8;
  colour.photometric = "RGB";
  write_series(colours.path(), colour);
  QVERIFY2(refusal_of(colours.path()).contains("colour picture"), qPrintable(refusal_of(colours.path())));
}

void DicomCornerTest::PixelsThatAreNotThereAreRefused() {
  const TemporaryFolder none, few;
  HandSlice slice;
  slice.other["7fe0|0010"] = "";
  write_series(none.path(), slice);
  QVERIFY(!refusal_of(none.path()).isEmpty());
  slice.other["7fe0|0010"] = std::string(20, 'x');  // of 60 bytes
  write_series(few.path(), slice);
  QVERIFY(!refusal_of(few.path()).isEmpty());
  // Files that a broken copy has cut off in the middle of their pixels, or by their last byte.
  for (const std::size_t lost : {std::size_t(30), std::size_t(1)}) {
    const TemporaryFolder cut;
    write_series(cut.path());
    const fs::path victim = cut.path() / (HandSlice().series + "_3");
    const std::string bytes = read_file(victim);
    write_file_atomically(victim, bytes.substr(0, bytes.size() - lost));
    QVERIFY2(!refusal_of(cut.path()).isEmpty(), "cut");
  }
}

void DicomCornerTest::ACutOrDamagedCompressedSliceDoesNoHarm() {
  for (const auto syntax : {gdcm::TransferSyntax::JPEGLosslessProcess14_1,
                            gdcm::TransferSyntax::JPEG2000Lossless, gdcm::TransferSyntax::RLELossless}) {
    const TemporaryFolder folder;
    HandSlice slice;
    slice.zoom = 8;
    write_series(folder.path(), slice);
    for (const auto& file : fs::directory_iterator(folder.path())) QVERIFY(recode(file.path(), syntax));
    const fs::path victim = folder.path() / (HandSlice().series + "_3");
    std::string bytes = read_file(victim);
    write_file_atomically(victim, bytes.substr(0, bytes.size() - 30));
    QVERIFY2(!refusal_of(folder.path()).isEmpty(), "cut");
    // The code is overwritten from its middle on, its length stays. These codes carry no check sum: what
    // comes of it may be a picture, but nobody is taken down by it.
    const std::size_t pixels = bytes.rfind(std::string("\xFE\xFF\x00\xE0", 4)) + 8;
    std::fill(bytes.begin() + static_cast<std::ptrdiff_t>((pixels + bytes.size()) / 2), bytes.end() - 8,
              '\0');
    write_file_atomically(victim, bytes);
    if (refusal_of(folder.path()).isEmpty()) QCOMPARE(image_in(folder.path()).grid.size.z(), kSlices);
  }
}

QTEST_APPLESS_MAIN(DicomCornerTest)
#include "dicom_corner_test.moc"
