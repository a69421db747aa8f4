// SPDX-License-Identifier: GPL-3.0-or-later
// The series of a folder as a hospital hands it out, made here file by file: told, judged and sorted.
#include "glisson/volume/series.h"

#include <QTest>
#include <algorithm>
#include <functional>

#include "dicom_bytes.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/io.h"

using namespace glisson;
using glisson::test::HandSlice;
namespace fs = std::filesystem;

namespace {

using Change = std::function<void(int, HandSlice&, std::string&)>;

/// @param pixels changes the file's last bytes, which are its pixels (two bytes each).
void write_series(const fs::path& folder, const std::string& name, int slices, HandSlice like,
                  const std::function<void(std::string&)>& pixels = {}) {
  like.series = "1.2.826.0.1.3680043.2.1125.77." + name;
  like.description = name;
  for (int k = 0; k < slices; ++k) {
    HandSlice slice = like;
    slice.instance = k + 1;
    // Out of order, so that the middle is not that of the names.
    std::string bytes = test::dicom_of((k * 11) % slices, slice);
    if (pixels) pixels(bytes);
    write_file_atomically(folder / (name + "_" + std::to_string(k)), bytes);
  }
}

HandSlice like(const std::map<std::string, std::string>& other, double slice_mm = 0.0) {
  HandSlice slice;
  slice.other = other;
  (void)slice_mm;
  return slice;
}

constexpr std::size_t kPixelBytes = 2 * 6 * 5;

void make_mask(std::string& bytes) {
  for (std::size_t n = bytes.size() - kPixelBytes; n < bytes.size(); n += 2) {
    bytes[n] = static_cast<char>(n % 3 == 0 ? 255 : 0);
    bytes[n + 1] = 0;
  }
}

QStringList names_of(const std::vector<DicomSeries>& all) {
  QStringList names;
  for (const DicomSeries& series : all) names << QString::fromStdString(series.description);
  return names;
}

const DicomSeries& called(const std::vector<DicomSeries>& all, const std::string& name) {
  return *std::ranges::find_if(all, [&](const DicomSeries& series) { return series.description == name; });
}

bool has(const DicomSeries& series, SeriesDoubt doubt) {
  const auto doubts = doubts_about(series);
  return std::ranges::find(doubts, doubt) != doubts.end();
}

DicomSeries plain(int slices = 100) {
  DicomSeries series;
  series.modality = "CT";
  series.slices = slices;
  series.normal = {0, 0, 1};
  return series;
}

}  // namespace

class SeriesTest : public QObject {
  Q_OBJECT
 private slots:
  void AHospitalsFolderIsSorted();
  void FilesSayWhatASeriesIs();
  void PicturesShowTheMiddle();
  void PixelsThatCannotBeDecodedCostThePictureOnly();
  void TextsAreUtf8();
  void EachDoubtIsMeant_data();
  void EachDoubtIsMeant();
  void PhasesAreRead_data();
  void PhasesAreRead();
  void OrderIsThatOfTheReasons();
};

void SeriesTest::AHospitalsFolderIsSorted() {
  const TemporaryFolder folder;
  const std::string original = "ORIGINAL\\PRIMARY\\AXIAL";
  // Names in an order that is neither that wanted nor its reverse.
  write_series(folder.path(), "mask", 24, like({{"0008|0008", original}}), make_mask);
  write_series(folder.path(), "scout", 1, like({{"0008|0008", "ORIGINAL\\PRIMARY\\LOCALIZER"}}));
  write_series(folder.path(), "coronal", 30,
               like({{"0008|0008", "DERIVED\\SECONDARY\\MPR"}, {"0020|0037", "1\\0\\0\\0\\0\\-1"}}));
  write_series(folder.path(), "portal", 26, like({{"0008|0008", original}}));
  write_series(folder.path(), "arterial", 28, like({{"0008|0008", original}}));
  write_series(folder.path(), "short", 23, like({{"0008|0008", original}}));
  write_series(folder.path(), "copy", 40, like({{"0008|0008", "DERIVED\\SECONDARY\\AXIAL"}}));
  write_series(folder.path(), "few", 5, like({{"0008|0008", original}}));
  write_series(folder.path(), "pet", 50, like({{"0008|0060", "PT"}}));
  HandSlice report = like({{"0008|0060", "SR"}});
  report.sop_class = "1.2.840.10008.5.1.4.1.1.88.11";
  write_series(folder.path(), "report", 1, report);
  HandSlice segments = like({{"0008|0060", "SEG"}, {"0028|0008", "30"}});
  segments.sop_class = "1.2.840.10008.5.1.4.1.1.66.4";
  write_series(folder.path(), "segments", 1, segments);

  const auto all = list_series(folder.path(), RunContext()).value();
  QCOMPARE(names_of(all).join(' '),
           QString("portal short arterial copy pet few coronal scout mask report segments"));
  QVERIFY(doubts_about(all.front()).empty());
  QVERIFY(has(called(all, "mask"), SeriesDoubt::mask) && doubts_about(called(all, "mask")).size() == 1);
  QVERIFY(has(called(all, "scout"), SeriesDoubt::localizer) &&
          has(called(all, "scout"), SeriesDoubt::few_slices));
  QVERIFY(has(called(all, "coronal"), SeriesDoubt::reformatted));
  QVERIFY(has(called(all, "coronal"), SeriesDoubt::not_axial) &&
          has(called(all, "coronal"), SeriesDoubt::derived));
  QVERIFY(has(called(all, "pet"), SeriesDoubt::other_modality));
  for (const char* name : {"report", "segments"}) {
    QVERIFY(!called(all, name).images && has(called(all, name), SeriesDoubt::no_image));
    QVERIFY(!can_be_read(called(all, name)));
  }
  QVERIFY(can_be_read(all.front()) && !can_be_read(called(all, "scout")));
  // What is listed first is what is read when it is chosen; what is no image does not stand in its way.
  QCOMPARE(read_image(folder.path(), RunContext(), all.front().uid).value().grid.size.z(), 26);
}

void SeriesTest::FilesSayWhatASeriesIs() {
  const TemporaryFolder folder;
  write_series(folder.path(), "portal venous", 21,
               like({{"0008|0008", "ORIGINAL\\PRIMARY\\AXIAL"},
                     {"0008|0020", "20260130"},
                     {"0008|0021", "20260131"},
                     {"0008|1030", "Abdomen"},
                     {"0010|0010", "Doe^Jane"},
                     {"0010|0020", "4711"},
                     {"0018|0010", "Iomeprol"},
                     {"0018|0050", "2.5"},
                     {"0018|1030", "Liver 3 phases"}}));
  const DicomSeries series = list_series(folder.path(), RunContext()).value().front();
  QCOMPARE(series.slices, 21);
  QCOMPARE(series.patient, std::string("Doe Jane"));
  QCOMPARE(series.patient_id, std::string("4711"));
  QCOMPARE(series.date, std::string("2026-01-31"));  // of the series, not of the study
  QCOMPARE(series.study, std::string("Abdomen"));
  QCOMPARE(series.protocol, std::string("Liver 3 phases"));
  QCOMPARE(series.kind, std::string("ORIGINAL\\PRIMARY\\AXIAL"));
  QVERIFY(series.contrast_agent);
  QCOMPARE(series.thickness_mm, 2.5);
  QCOMPARE(series.pixels, Eigen::Vector2i(6, 5));
  QVERIFY((series.pixel_mm - test::kWorldSpacing.head<2>()).norm() < 1e-6);
  QVERIFY(std::abs(series.gap_mm - test::kWorldSpacing.z()) < 1e-6);
  QVERIFY((series.normal - Eigen::Vector3d::UnitZ()).norm() < 1e-9);
  QVERIFY(phase_of(series) == SeriesPhase::portal_venous);
}

void SeriesTest::PicturesShowTheMiddle() {
  const TemporaryFolder folder;
  // The middle one of 21 along the body alone is bright on its left half.
  HandSlice slice = like({});
  slice.series = "1.2.826.0.1.3680043.2.1125.78";
  for (int k = 0; k < 21; ++k) {
    std::string bytes = test::dicom_of(k, slice);
    for (std::size_t n = 0; n < kPixelBytes / 2; ++n) {
      const bool bright = k == 10 && n % 6 < 3;
      const int stored = 1024 + (bright ? 300 : -300) + static_cast<int>(n % 4);
      bytes[bytes.size() - kPixelBytes + 2 * n] = static_cast<char>(stored & 255);
      bytes[bytes.size() - kPixelBytes + 2 * n + 1] = static_cast<char>(stored >> 8);
    }
    write_file_atomically(folder.path() / std::to_string((k * 5) % 21), bytes);
  }
  const SeriesPicture picture = list_series(folder.path(), RunContext()).value().front().picture;
  QCOMPARE(picture.width, 6);
  QCOMPARE(picture.height, 5);
  QVERIFY(std::abs(picture.pixel_aspect - test::kWorldSpacing.y() / test::kWorldSpacing.x()) < 1e-9);
  QCOMPARE(picture.values, 8);
  for (std::size_t n = 0; n < picture.grey.size(); ++n) QCOMPARE(int(picture.grey[n]), n % 6 < 3 ? 255 : 0);
}

void SeriesTest::PixelsThatCannotBeDecodedCostThePictureOnly() {
  const TemporaryFolder folder;
  write_series(folder.path(), "whole", 23, like({}));
  write_series(folder.path(), "cut", 25, like({}),
               [](std::string& bytes) { bytes.resize(bytes.size() - 20); });
  const auto all = list_series(folder.path(), RunContext()).value();
  QCOMPARE(names_of(all).join(' '), QString("cut whole"));
  QVERIFY(all[0].picture.grey.empty() && all[0].picture.values == 0 && !has(all[0], SeriesDoubt::mask));
  QVERIFY(!all[1].picture.grey.empty());
  QVERIFY_THROWS_EXCEPTION(InputError, (void)read_image(folder.path(), RunContext(), all[0].uid));
}

void SeriesTest::TextsAreUtf8() {
  const TemporaryFolder folder;
  write_series(folder.path(), "a", 3,
               like({{"0010|0010", "M\xfcller^Zo\xeb"}, {"0008|1030", "Pat\nient\x1b[2J"}}));
  write_series(folder.path(), "b", 2,
               like({{"0010|0010", "M\xc3\xbcller"}, {"0008|1030", std::string(5000, 'x')}}));
  const auto all = list_series(folder.path(), RunContext()).value();
  QCOMPARE(called(all, "a").patient, std::string("M\xc3\xbcller Zo\xc3\xab"));
  QCOMPARE(called(all, "a").study, std::string("Pat ient [2J"));
  QCOMPARE(called(all, "b").patient, std::string("M\xc3\xbcller"));
  QVERIFY(called(all, "b").study.size() <= 200);
}

void SeriesTest::EachDoubtIsMeant_data() {
  QTest::addColumn<std::function<void(DicomSeries&)>>("change");
  QTest::addColumn<QList<int>>("doubts");
  const auto row = [](const char* name, std::function<void(DicomSeries&)> change,
                      std::vector<SeriesDoubt> doubts) {
    QList<int> numbers;
    for (const SeriesDoubt doubt : doubts) numbers << static_cast<int>(doubt);
    QTest::newRow(name) << std::move(change) << numbers;
  };
  using enum SeriesDoubt;
  row("nothing", [](DicomSeries&) {}, {});
  row("nothing is said", [](DicomSeries& s) { s.normal.setZero(), s.kind = ""; }, {});
  row("original", [](DicomSeries& s) { s.kind = "ORIGINAL\\PRIMARY\\AXIAL\\CT_SOM5 SPI"; }, {});
  row("derived", [](DicomSeries& s) { s.kind = "DERIVED\\PRIMARY\\AXIAL"; }, {derived});
  row("secondary", [](DicomSeries& s) { s.kind = "SECONDARY\\OTHER"; }, {derived});
  row("another reconstruction", [](DicomSeries& s) { s.kind = "ORIGINAL\\SECONDARY\\AXIAL"; }, {});
  row("a word within", [](DicomSeries& s) { s.kind = "ORIGINAL\\PRIMARY\\NOTDERIVED"; }, {});
  row("19 slices", [](DicomSeries& s) { s.slices = 19; }, {few_slices});
  row("20 slices", [](DicomSeries& s) { s.slices = 20; }, {});
  row("MR", [](DicomSeries& s) { s.modality = "MR"; }, {});
  row("ultrasound", [](DicomSeries& s) { s.modality = "US"; }, {other_modality});
  row("coronal", [](DicomSeries& s) { s.normal = {0, 1, 0}; }, {not_axial});
  row("feet first", [](DicomSeries& s) { s.normal = {0, 0, -1}; }, {});
  row("gantry of 20 degrees", [](DicomSeries& s) { s.normal = {0, 0.342, 0.940}; }, {});
  row("MPR", [](DicomSeries& s) { s.kind = "DERIVED\\PRIMARY\\MPR"; }, {derived, reformatted});
  row("MIP by name", [](DicomSeries& s) { s.description = "Abdomen MIP cor"; }, {reformatted});
  row("no MIP by name", [](DicomSeries& s) { s.description = "ramipril"; }, {});
  row("topogram", [](DicomSeries& s) { s.description = "Topogram 0.6", s.slices = 1; },
      {few_slices, localizer});
  row("screenshot", [](DicomSeries& s) { s.modality = "OT", s.slices = 2; }, {few_slices, screenshot});
  row("frames", [](DicomSeries& s) { s.frames = 60, s.slices = 1; }, {frames});
  row("mask", [](DicomSeries& s) { s.picture.values = 2; }, {mask});
  row("empty mask", [](DicomSeries& s) { s.picture.values = 1; }, {mask});
  row("three values", [](DicomSeries& s) { s.picture.values = 3; }, {});
  row("contours", [](DicomSeries& s) { s.images = false, s.modality = "RTSTRUCT", s.slices = 1; },
      {no_image});
}

void SeriesTest::EachDoubtIsMeant() {
  QFETCH(std::function<void(DicomSeries&)>, change);
  QFETCH(QList<int>, doubts);
  DicomSeries series = plain();
  change(series);
  QList<int> found;
  for (const SeriesDoubt doubt : doubts_about(series)) found << static_cast<int>(doubt);
  QCOMPARE(found, doubts);
}

void SeriesTest::PhasesAreRead_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<int>("phase");
  const auto row = [](const char* text, SeriesPhase phase) {
    QTest::newRow(text) << QString::fromUtf8(text) << static_cast<int>(phase);
  };
  using enum SeriesPhase;
  row("Abd 2.0 B30f portal venous", portal_venous);
  row("Abdomen PV 3.0", portal_venous);
  row("LEBER PORTALVENÖS", portal_venous);
  row("Recon 3: LIVER 3 PHASE (ART)", arterial);
  row("temps artériel", arterial);
  row("Spätphase 5 min", delayed);
  row("Delayed venous", delayed);
  row("portal venous delay 70 s", portal_venous);
  row("Abdomen delay: 35s arterial", arterial);
  row("delay 70 s", unsaid);
  row("venous delay 180 s", delayed);
  row("delay 5 min", delayed);
  row("Abd venous delay 3.0 B30f", delayed);
  row("delay 3 slices", delayed);
  row("portal delay 65sec", portal_venous);
  row("nativ 3.0", native);
  row("Nativphase 2.0", native);
  row("alternative recon 2.0", unsaid);
  row("start of the series", unsaid);
  row("Abdomen 3.0", unsaid);
  row("", unsaid);
}

void SeriesTest::PhasesAreRead() {
  QFETCH(QString, text);
  QFETCH(int, phase);
  DicomSeries series = plain();
  series.description = text.toStdString();
  QCOMPARE(static_cast<int>(phase_of(series)), phase);
  std::swap(series.description, series.protocol);
  QCOMPARE(static_cast<int>(phase_of(series)), phase);
}

void SeriesTest::OrderIsThatOfTheReasons() {
  std::vector<DicomSeries> wanted;
  const auto add = [&](const std::function<void(DicomSeries&)>& change) {
    wanted.push_back(plain());
    change(wanted.back());
    wanted.back().uid = std::to_string(wanted.size());
  };
  add([](DicomSeries& s) { s.slices = 300; });
  add([](DicomSeries& s) { s.slices = 100, s.gap_mm = 1.0; });
  add([](DicomSeries& s) { s.slices = 100, s.gap_mm = 2.0, s.thickness_mm = 0.5; });
  add([](DicomSeries& s) { s.slices = 100, s.thickness_mm = 3.0; });
  add([](DicomSeries& s) { s.slices = 100, s.number = "2"; });
  add([](DicomSeries& s) { s.slices = 100, s.number = "10"; });
  add([](DicomSeries& s) { s.slices = 500, s.description = "arterial"; });
  add([](DicomSeries& s) { s.slices = 900, s.modality = "MR"; });
  add([](DicomSeries& s) { s.slices = 900, s.kind = "DERIVED\\SECONDARY"; });
  add([](DicomSeries& s) { s.slices = 900, s.normal = {1, 0, 0}; });
  add([](DicomSeries& s) { s.slices = 900, s.picture.values = 2; });
  std::mt19937 random(4);
  for (int turn = 0; turn < 20; ++turn) {
    std::vector<DicomSeries> all = wanted;
    std::shuffle(all.begin(), all.end(), random);
    sort_by_likelihood(all);
    for (std::size_t n = 0; n < all.size(); ++n) QCOMPARE(all[n].uid, wanted[n].uid);
  }
}

QTEST_APPLESS_MAIN(SeriesTest)
#include "series_test.moc"
