// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/correction.h"

#include <QTest>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/patient/overlay_record.h"

using namespace glisson;

class CorrectionTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatIsWrittenIsRead();
  void ALineByHandNeedsNoPlace();
  void BadLinesAreNamed_data();
  void BadLinesAreNamed();
  void ARecordOfATrackMayHoldThem();

 private:
  std::filesystem::path written(const std::string& text) const {
    const std::filesystem::path path = folder_.path() / "corrections.jsonl";
    write_file_atomically(path, text);
    return path;
  }
  TemporaryFolder folder_;
};

void CorrectionTest::WhatIsWrittenIsRead() {
  CorrectionMade made;
  made.correction = {CorrectedFeature::notch, {0.01, -0.02, 0.03}, StereoView::right,
                     {480.5, 270.0},          {492.0, 274.25},     3.0};
  made.frame = 12;
  made.seconds = 0.4;
  made.moved = 5e-3;
  // The order of the frames counts.
  const auto lines = read_corrections(written(undone_line(20, 0.7) + "\n\n" + correction_line(made) + "\n"));
  QCOMPARE(lines.size(), std::size_t{2});
  QVERIFY(lines[0].correction && lines[0].has_place && !lines[1].correction);
  QCOMPARE(lines[0].frame, 12);
  QCOMPARE(lines[0].seconds, 0.4);
  QCOMPARE(lines[1].frame, 20);
  const Correction& read = *lines[0].correction;
  QCOMPARE(read.feature, CorrectedFeature::notch);
  QCOMPARE(read.view, StereoView::right);
  QVERIFY((read.place_in_ct - made.correction.place_in_ct).norm() < 1e-12);
  QVERIFY(read.from == made.correction.from && read.to == made.correction.to);
  QCOMPARE(read.sigma_px, 3.0);
}

void CorrectionTest::ALineByHandNeedsNoPlace() {
  const auto lines = read_corrections(written(R"({"frame": 3, "correct": {"from": [1, 2], "to": [3, 4]}})"));
  QVERIFY(lines.size() == 1 && lines[0].correction && !lines[0].has_place);
  QCOMPARE(lines[0].correction->view, StereoView::left);
  QCOMPARE(lines[0].correction->sigma_px, Correction().sigma_px);
}

void CorrectionTest::BadLinesAreNamed_data() {
  QTest::addColumn<QString>("line");
  QTest::newRow("no JSON") << "{\"correct\"";
  QTest::newRow("no frame") << R"({"correct": "undo"})";
  QTest::newRow("half a frame") << R"({"frame": 1.5, "correct": "undo"})";
  QTest::newRow("a frame of no film") << R"({"frame": 4294967297, "correct": "undo"})";
  QTest::newRow("another word") << R"({"frame": 1, "correct": "redo"})";
  QTest::newRow("no target") << R"({"frame": 1, "correct": {"from": [1, 2]}})";
  QTest::newRow("three coordinates") << R"({"frame": 1, "correct": {"from": [1, 2, 3], "to": [3, 4]}})";
  QTest::newRow("a third eye") << R"({"frame": 1, "correct": {"view": "top", "from": [1, 2], "to": [3, 4]}})";
  QTest::newRow("no deviation")
      << R"({"frame": 1, "correct": {"from": [1, 2], "to": [3, 4], "sigma_px": 0}})";
  QTest::newRow("outside any picture") << R"({"frame": 1, "correct": {"from": [1, 2], "to": [1e300, 4]}})";
  QTest::newRow("outside the world")
      << R"({"frame": 1, "correct": {"from": [1, 2], "to": [3, 4], "place_mm": [0, 1e300, 0]}})";
  QTest::newRow("words") << R"({"frame": 1, "correct": {"from": ["a", 2], "to": [3, 4]}})";
}

void CorrectionTest::BadLinesAreNamed() {
  QFETCH(QString, line);
  const auto path = written(undone_line(1, 0.0) + "\n" + line.toStdString() + "\n");
  try {
    read_corrections(path);
    QFAIL("accepted");
  } catch (const InputError& error) {
    QVERIFY2(std::string(error.what()).find("line 2") != std::string::npos, error.what());
  }
}

void CorrectionTest::ARecordOfATrackMayHoldThem() {
  OverlayLine frame;
  frame.number = 4;
  const auto path =
      written(overlay_line(frame) + "\n" + undone_line(4, 0.1) + "\n" + overlay_record_end(true, 1) + "\n");
  QCOMPARE(read_overlay_record(path).frames.size(), std::size_t{1});
  QVERIFY(read_overlay_record(path).complete);
  QCOMPARE(read_corrections(path).size(), std::size_t{1});
}

QTEST_APPLESS_MAIN(CorrectionTest)
#include "correction_test.moc"
