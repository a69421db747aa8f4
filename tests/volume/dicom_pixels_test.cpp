// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <functional>

#include "complaint.h"
#include "dicom_bytes.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/io.h"
#include "phantom.h"

using namespace glisson;
using test::HandSlice;
namespace fs = std::filesystem;

/// Slices of which pixels are missing, or that make intensities of them in another way than their series.
class DicomPixelsTest : public QObject {
  Q_OBJECT
 private slots:
  void ACutSliceIsRefused();
  void BytesPutInAmongThePixelsAreRefused();
  void ASliceOfAnotherKindIsRefused_data();
  void ASliceOfAnotherKindIsRefused();
  void InMrEachSliceMayHaveAScaleOfItsOwn();
};

namespace {

constexpr int kSlices = 4;

void write_series(
    const fs::path& folder, const HandSlice& like = {},
    const std::function<void(HandSlice&)>& change = [](HandSlice&) {}) {
  for (int k = 0; k < kSlices; ++k) {
    HandSlice slice = like;
    if (k == 2) change(slice);
    write_file_atomically(folder / std::to_string(k), test::dicom_of(k, slice));
  }
}

QString refusal_of(const fs::path& path) {
  return QString::fromStdString(test::complaint([&] { (void)read_image(path, RunContext()); }));
}

}  // namespace

void DicomPixelsTest::ACutSliceIsRefused() {
  const TemporaryFolder folder;
  HandSlice slice;
  slice.zoom = 16;
  const std::size_t pixels = std::size_t(2) * 6 * 5 * 16 * 16;
  write_series(folder.path(), slice);
  QCOMPARE(refusal_of(folder.path()), QString());
  const fs::path victim = folder.path() / "2";
  const std::string whole = read_file(victim);
  std::vector<std::size_t> lost = {1, 2, 3, pixels - 1};
  for (std::size_t tenth = 1; tenth <= 10; ++tenth) lost.push_back(pixels * tenth / 10);
  for (const std::size_t bytes : lost) {
    write_file_atomically(victim, whole.substr(0, whole.size() - bytes));
    const QString told = refusal_of(folder.path());
    QVERIFY2(told.contains("2, PixelData (7fe0|0010): ends early: the slice was cut"),
             qPrintable(QString::number(bytes) + ": " + told));
  }
}

void DicomPixelsTest::BytesPutInAmongThePixelsAreRefused() {
  const TemporaryFolder folder;
  write_series(folder.path(), {});
  const fs::path victim = folder.path() / "2";
  const std::string whole = read_file(victim);
  for (const std::size_t more : {2U, 4U, 8U, 100U}) {
    std::string longer = whole;
    longer.insert(longer.size() - 30, std::string(more, '\x55'));
    write_file_atomically(victim, longer);
    const QString told = refusal_of(folder.path());
    QVERIFY2(!told.isEmpty(), qPrintable(QString::number(more)));
    // What is long enough to be taken for an element may be too much for GDCM already.
    const bool is_ours = told.contains("2, PixelData (7fe0|0010): is followed by no element");
    QVERIFY2(is_ours || more > 2, qPrintable(told));
  }
  // What may follow: the padding of a medium, and elements of a higher tag.
  const std::string padding("\xFC\xFF\xFC\xFFOB\0\0\x04\0\0\0abcd", 16);
  for (const std::string& more : {std::string(512, '\0'), padding}) {
    write_file_atomically(victim, whole + more);
    QCOMPARE(refusal_of(folder.path()), QString());
  }
}

void DicomPixelsTest::ASliceOfAnotherKindIsRefused_data() {
  QTest::addColumn<QString>("tag");
  QTest::addColumn<QByteArray>("value");
  QTest::addColumn<QString>("field");
  const auto number = [](int value) { return QByteArray::fromStdString(test::short_of(value)); };
  QTest::newRow("slope") << "0028|1053" << QByteArray("2") << "RescaleSlope";
  QTest::newRow("intercept") << "0028|1052" << QByteArray("-24") << "RescaleIntercept";
  QTest::newRow("no slope") << "0028|1053" << QByteArray() << "RescaleSlope";
  QTest::newRow("no intercept") << "0028|1052" << QByteArray() << "RescaleIntercept";
  QTest::newRow("stored bits") << "0028|0101" << number(8) << "BitsStored";
  QTest::newRow("high bit") << "0028|0102" << number(11) << "HighBit";
  QTest::newRow("sign") << "0028|0103" << number(1) << "PixelRepresentation";
  QTest::newRow("allocated bits") << "0028|0100" << number(8) << "BitsAllocated";
  QTest::newRow("fewer rows") << "0028|0010" << number(4) << "has another size";
  QTest::newRow("slope of nothing") << "0028|1053" << QByteArray("1e-300") << "RescaleSlope";
}

void DicomPixelsTest::ASliceOfAnotherKindIsRefused() {
  QFETCH(QString, tag);
  QFETCH(QByteArray, value);
  QFETCH(QString, field);
  const TemporaryFolder folder;
  write_series(folder.path(), {},
               [&](HandSlice& slice) { slice.other[tag.toStdString()] = value.toStdString(); });
  const QString told = refusal_of(folder.path());
  QVERIFY2(told.contains(field), qPrintable(told));
  // In all slices: what cannot be is refused there, too.
  if (field != "has another size" && value != "1e-300") return;
  HandSlice all;
  all.other[tag.toStdString()] = value.toStdString();
  write_series(folder.path(), all);
  const QString of_all = refusal_of(folder.path());
  QVERIFY2(of_all.contains(value == "1e-300" ? "RescaleSlope" : "Rows, Columns"), qPrintable(of_all));
}

void DicomPixelsTest::InMrEachSliceMayHaveAScaleOfItsOwn() {
  const TemporaryFolder folder;
  HandSlice slice;
  slice.other["0008|0060"] = "MR";
  write_series(folder.path(), slice, [](HandSlice& other) {
    other.slope = 2.0;
    other.intercept = -1000.0;
  });
  QVERIFY2(refusal_of(folder.path()).isEmpty(), qPrintable(refusal_of(folder.path())));
  QCOMPARE(read_image(folder.path(), RunContext()).value().modality, Modality::mr);
  write_series(folder.path(), slice, [](HandSlice& other) { other.other["0028|1053"] = ""; });
  QVERIFY(refusal_of(folder.path()).contains("RescaleSlope"));
}

QTEST_APPLESS_MAIN(DicomPixelsTest)
#include "dicom_pixels_test.moc"
