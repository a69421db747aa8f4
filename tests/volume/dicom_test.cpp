// SPDX-License-Identifier: GPL-3.0-or-later
#include <itkGDCMImageIO.h>
#include <itkImage.h>
#include <itkImageFileWriter.h>
#include <itkMetaDataObject.h>

#include <QTest>
#include <fstream>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/io.h"
#include "phantom.h"

using namespace glisson;
namespace fs = std::filesystem;

namespace {

using Slice = itk::Image<short, 3>;

/// How a slice is written.
struct SliceOptions {
  std::string series = "1.2.826.0.1.3680043.2.1125.1";
  std::string photometric, transfer;  ///< empty: as GDCM likes
  Eigen::Vector3d shift_mm = Eigen::Vector3d::Zero();
  bool colour = false;
};

void set_tag(itk::MetaDataDictionary& tags, const char* tag, const std::string& value) {
  itk::EncapsulateMetaData<std::string>(tags, tag, value);
}

/// Slice k of an image as a DICOM file of its own, by ITK and GDCM.
void write_slice(const fs::path& path, const Image& image, int k, const SliceOptions& options = {}) {
  const auto slice = Slice::New();
  Slice::RegionType region;
  region.SetSize(
      {static_cast<unsigned>(image.grid.size.x()), static_cast<unsigned>(image.grid.size.y()), 1U});
  slice->SetRegions(region);
  slice->Allocate();
  Slice::PointType origin;
  Slice::SpacingType spacing;
  Slice::DirectionType direction;
  const Eigen::Vector3d p = 1e3 * image.grid.p_in_ct(Eigen::Vector3d(0, 0, k)).xyz + options.shift_mm;
  for (unsigned a = 0; a < 3; ++a) {
    origin[a] = p[a];
    spacing[a] = image.grid.spacing_mm[a];
    for (unsigned b = 0; b < 3; ++b) direction[a][b] = image.grid.direction(a, b);
  }
  slice->SetOrigin(origin);
  slice->SetSpacing(spacing);
  slice->SetDirection(direction);
  for (int j = 0; j < image.grid.size.y(); ++j)
    for (int i = 0; i < image.grid.size.x(); ++i) slice->SetPixel({i, j, 0}, image.at({i, j, k}));
  const auto io = itk::GDCMImageIO::New();
  io->KeepOriginalUIDOn();
  if (options.transfer == "jpeg") {
    io->SetCompressionType(itk::GDCMImageIO::CompressionEnum::JPEG);
    io->UseCompressionOn();
  }
  itk::MetaDataDictionary& tags = slice->GetMetaDataDictionary();
  set_tag(tags, "0008|0060", "CT");
  set_tag(tags, "0008|0016", "1.2.840.10008.5.1.4.1.1.2");
  set_tag(tags, "0008|0018", options.series + ".9." + std::to_string(k + 1));
  set_tag(tags, "0020|000d", "1.2.826.0.1.3680043.2.1125.7");
  set_tag(tags, "0020|000e", options.series);
  set_tag(tags, "0008|103e", "portal venous");
  set_tag(tags, "0028|1052", "-1024");
  set_tag(tags, "0028|1053", "1");
  if (!options.photometric.empty()) set_tag(tags, "0028|0004", options.photometric);
  const auto writer = itk::ImageFileWriter<Slice>::New();
  writer->SetFileName(path.string());
  writer->SetImageIO(io);
  writer->UseInputMetaDataDictionaryOff();
  io->SetMetaDataDictionary(tags);
  writer->SetInput(slice);
  writer->Update();
}

/// All slices of an image, named so that the file order is not the order in space.
void write_series(const fs::path& folder, const Image& image, const SliceOptions& options = {},
                  int without = -1) {
  for (int k = 0; k < image.grid.size.z(); ++k)
    if (k != without) write_slice(folder / ("slice" + std::to_string((k * 7 + 3) % 11)), image, k, options);
}

QString refusal_of(const fs::path& path) {
  try {
    (void)read_image(path, RunContext());
  } catch (const InputError& error) {
    return QString::fromStdString(error.what());
  }
  return "";
}

}  // namespace

class DicomTest : public QObject {
  Q_OBJECT
 private slots:
  void EveryOrientationShowsTheSamePatient();
  void ArchivesAreUnpacked();
  void CompressedAndInvertedSlicesKeepTheirUnits();
  void OtherFilesInTheFolderArePassedOver();
  void TwoSeriesAreRefused();
  void AMissingSliceIsRefused();
  void PlacesRoundedToATenthOfAMillimetreAreTaken();
  void GantryTiltIsRefused();
  void ASliceBesideItsPlaceIsRefused();
  void TwoSlicesAtOnePlaceAreRefused();
  void ASingleSliceIsRefused();
  void DamagedSlicesNeverTakeTheProcessDown();
};

void DicomTest::EveryOrientationShowsTheSamePatient() {
  for (const int orientation : {0, 3, 6, 9, 13, 18, 23, 28, 33, 39, 42, 47}) {
    const TemporaryFolder folder;
    // Slices that run backwards (a left-handed stack) come out sorted along their normal.
    write_series(folder.path(), test::stored_world(orientation));
    const Image back = read_image(folder.path(), RunContext()).value();
    QVERIFY2(test::shows_world(back), qPrintable(QString("orientation %1").arg(orientation)));
    QVERIFY(back.grid.direction.determinant() > 0.0);
    QCOMPARE(back.modality, Modality::ct);
    QCOMPARE(back.description, std::string("portal venous"));
  }
}

void DicomTest::ArchivesAreUnpacked() {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "series");
  write_series(folder.path() / "series", test::stored_world(0));
  const std::string archive = (folder.path() / "series.tar.gz").string();
  QCOMPARE(std::system(("tar -czf " + archive + " -C " + folder.path().string() + " series").c_str()), 0);
  QVERIFY(test::shows_world(read_image(archive, RunContext()).value()));
}

void DicomTest::CompressedAndInvertedSlicesKeepTheirUnits() {
  SliceOptions options;
  {
    const TemporaryFolder folder;
    options.transfer = "jpeg";  // lossless
    write_series(folder.path(), test::stored_world(0), options);
    QVERIFY(test::shows_world(read_image(folder.path(), RunContext()).value()));
  }
  const TemporaryFolder folder;
  options.transfer.clear();
  options.photometric = "MONOCHROME1";  // says how to draw, not what the numbers mean
  write_series(folder.path(), test::stored_world(0), options);
  QVERIFY(test::shows_world(read_image(folder.path(), RunContext()).value()));
}

void DicomTest::OtherFilesInTheFolderArePassedOver() {
  const TemporaryFolder folder;
  write_series(folder.path(), test::stored_world(5));
  std::ofstream(folder.path() / "README.txt") << "burnt by a viewer";
  std::ofstream(folder.path() / "empty");
  QVERIFY(test::shows_world(read_image(folder.path(), RunContext()).value()));
}

void DicomTest::TwoSeriesAreRefused() {
  const TemporaryFolder folder;
  write_series(folder.path(), test::stored_world(0));
  SliceOptions other;
  other.series += "99";
  write_slice(folder.path() / "other", test::stored_world(0), 0, other);
  const QString refusal = refusal_of(folder.path());
  QVERIFY2(refusal.contains("holds 2 series") && refusal.contains("folder of its own"), qPrintable(refusal));
}

void DicomTest::AMissingSliceIsRefused() {
  const TemporaryFolder folder;
  write_series(folder.path(), test::stored_world(0), {}, 2);
  QVERIFY2(refusal_of(folder.path()).contains("a slice is missing"), qPrintable(refusal_of(folder.path())));
}

void DicomTest::PlacesRoundedToATenthOfAMillimetreAreTaken() {
  const Image image = test::stored_world(0);
  const int count = image.grid.size.z();
  for (const double gap : {0.625, 0.75, 1.25, 2.5}) {
    const TemporaryFolder folder;
    for (int k = 0; k < 40; ++k) {
      SliceOptions rounded;
      rounded.shift_mm.z() = 0.1 * std::round(10.0 * gap * k) - 2.5 * (k % count);
      write_slice(folder.path() / std::to_string(100 + k), image, k % count, rounded);
    }
    QVERIFY2(refusal_of(folder.path()).isEmpty(), qPrintable(refusal_of(folder.path())));
    fs::remove(folder.path() / "117");
    QVERIFY2(refusal_of(folder.path()).contains("a slice is missing"), qPrintable(refusal_of(folder.path())));
  }
}

void DicomTest::GantryTiltIsRefused() {
  const TemporaryFolder folder;
  const Image image = test::stored_world(0);
  for (int k = 0; k < image.grid.size.z(); ++k) {
    SliceOptions tilted;
    tilted.shift_mm = Eigen::Vector3d(0.0, 0.7 * k, 0.0);
    write_slice(folder.path() / std::to_string(k), image, k, tilted);
  }
  QVERIFY2(refusal_of(folder.path()).contains("gantry tilt"), qPrintable(refusal_of(folder.path())));
}

void DicomTest::ASliceBesideItsPlaceIsRefused() {
  const Image image = test::stored_world(0);
  const int count = image.grid.size.z();
  const TemporaryFolder aside, uneven;
  for (int k = 0; k < count; ++k) {
    SliceOptions one;
    if (k == 1) one.shift_mm = Eigen::Vector3d(8.0, 0.0, 0.0);
    write_slice(aside.path() / std::to_string(k), image, k, one);
  }
  QVERIFY2(refusal_of(aside.path()).contains("no regular stack"), qPrintable(refusal_of(aside.path())));
  // Forty slices of 2.5 mm and forty of 2.6, each gap nearly the usual one.
  for (int k = 0; k < 80; ++k) {
    SliceOptions one;
    one.shift_mm.z() = 2.5 * (k - k % count) + 0.1 * std::max(0, k - 40);
    write_slice(uneven.path() / std::to_string(100 + k), image, k % count, one);
  }
  QVERIFY2(refusal_of(uneven.path()).contains("no regular stack"), qPrintable(refusal_of(uneven.path())));
}

void DicomTest::TwoSlicesAtOnePlaceAreRefused() {
  const TemporaryFolder folder;
  write_series(folder.path(), test::stored_world(0));
  write_slice(folder.path() / "again", test::stored_world(0), 1);
  QVERIFY2(refusal_of(folder.path()).contains("same place"), qPrintable(refusal_of(folder.path())));
}

void DicomTest::ASingleSliceIsRefused() {
  const TemporaryFolder folder;
  write_slice(folder.path() / "one", test::stored_world(0), 0);
  QVERIFY2(refusal_of(folder.path()).contains("single slice"), qPrintable(refusal_of(folder.path())));
}

void DicomTest::DamagedSlicesNeverTakeTheProcessDown() {
  const TemporaryFolder folder;
  write_series(folder.path(), test::stored_world(0));
  const fs::path victim = folder.path() / "slice3";
  const std::string good = read_file(victim);
  std::mt19937 random(23);
  for (int mutant = 0; mutant < 16; ++mutant) {
    std::string bytes = good;
    if (mutant % 4 == 0)
      bytes.resize(132 + random() % (bytes.size() - 132));
    else
      for (int flips = 0; flips < 8; ++flips)
        bytes[128 + random() % (bytes.size() - 128)] ^= static_cast<char>(1u << (random() % 8));
    std::ofstream(victim, std::ios::binary | std::ios::trunc) << bytes;
    const QString refusal = refusal_of(folder.path());
    // A slice that is cut is never taken for a whole one.
    if (mutant % 4 == 0) QVERIFY2(!refusal.isEmpty(), qPrintable(QString("cut at %1").arg(bytes.size())));
  }
}

QTEST_APPLESS_MAIN(DicomTest)
#include "dicom_test.moc"
