// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/network/label_sheet.h"

#include <QTest>

#include "complaint.h"
#include "glisson/core/files.h"

using namespace glisson;
using namespace glisson::network;

class LabelSheetTest : public QObject {
  Q_OBJECT
  TemporaryFolder folder_;
  LabelSheet read(const std::string& text) const {
    write_file_atomically(folder_.path() / "net.json", text);
    return read_label_sheet(folder_.path() / "net.onnx");
  }

 private slots:
  void AllFieldsAreRead();
  void WhatIsLeftOutHasItsUsualValue();
  void WhatIsWrongIsNamedByField_data();
  void WhatIsWrongIsNamedByField();
  void AMissingSheetIsNamed();
  void LesionsStandForAnyLesion();
};

void LabelSheetTest::AllFieldsAreRead() {
  const LabelSheet sheet = read(
      R"({"window_hu": [-100, 200], "mean_hu": 50, "sd_hu": 40, "spacing_mm": [2.5, 0.8, 0.8], "axes": "IAR",
          "tile": [32, 64, 96], "overlap": 0.25, "channels": ["background", "parenchyma", "lesions", "vena_cava"],
          "threshold": 0.4, "least_lesion_ml": 1})");
  QCOMPARE(sheet.window_low_hu, -100.0);
  QCOMPARE(sheet.window_high_hu, 200.0);
  QCOMPARE(*sheet.mean_hu, 50.0);
  QCOMPARE(*sheet.sd_hu, 40.0);
  QCOMPARE(sheet.spacing_mm, (std::vector<double>{2.5, 0.8, 0.8}));
  QCOMPARE(sheet.axes, std::string("IAR"));
  QCOMPARE(sheet.tile, (std::vector<int>{32, 64, 96}));
  QCOMPARE(sheet.overlap, 0.25);
  QCOMPARE(sheet.channels, (std::vector<Label>{structure::kBackground, structure::kParenchyma,
                                               LabelSheet::kLesions, structure::kVenaCava}));
  QCOMPARE(*sheet.threshold, 0.4);
  QCOMPARE(sheet.least_lesion_ml, 1.0);
}

void LabelSheetTest::WhatIsLeftOutHasItsUsualValue() {
  const LabelSheet sheet = read(R"({"window_hu": [-100, 200], "channels": ["background", "parenchyma"]})");
  QVERIFY(!sheet.mean_hu && !sheet.threshold && sheet.tile.empty() && sheet.spacing_mm.empty());
  QCOMPARE(sheet.axes, std::string("SPL"));
  QCOMPARE(sheet.overlap, 0.5);
}

void LabelSheetTest::WhatIsWrongIsNamedByField_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("field");
  const auto row = [](const char* more, const char* field) {
    QStringList entries = {QString(more)};
    for (const char* entry : {R"("channels": ["background", "parenchyma"])", R"("window_hu": [0, 1])"})
      if (!entries[0].startsWith(QString(entry).section(':', 0, 0))) entries << QString(entry);
    QTest::newRow(more) << '{' + entries.join(", ") + '}' << QString(field);
  };
  row(R"("windows_hu": [0, 1])", "windows_hu");
  row(R"("window_hu": [5, 5])", "window_hu");
  row(R"("window_hu": ["a", 5])", "window_hu");
  row(R"("mean_hu": 5)", "sd_hu");
  row(R"("sd_hu": 0)", "sd_hu");
  row(R"("spacing_mm": [1])", "spacing_mm");
  row(R"("spacing_mm": [1, 0])", "spacing_mm");
  row(R"("axes": "SPP")", "axes");
  row(R"("axes": "SP")", "axes");
  row(R"("axes": 5)", "axes");
  row(R"("tile": [8])", "tile");
  row(R"("tile": 8)", "tile");
  row(R"("tile": [8.5, 8])", "tile");
  row(R"("overlap": 1)", "overlap");
  row(R"("channels": ["liver"])", "channels");
  row(R"("channels": ["lesion_1"])", "channels");
  row(R"("channels": ["background"])", "channels");
  row(R"("channels": [1])", "channels");
  row(R"("channels": ["parenchyma"])", "threshold");
  row(R"("least_lesion_ml": -1)", "least_lesion_ml");
}

void LabelSheetTest::WhatIsWrongIsNamedByField() {
  QFETCH(QString, text);
  QFETCH(QString, field);
  const std::string refused = test::refused_field([&] { (void)read(text.toStdString()); });
  QCOMPARE(QString::fromStdString(refused), field);
}

void LabelSheetTest::AMissingSheetIsNamed() {
  const std::string told =
      test::complaint<Error>([&] { (void)read_label_sheet(folder_.path() / "other.onnx"); });
  QVERIFY2(told.find("other.json") != std::string::npos, told.c_str());
}

void LabelSheetTest::LesionsStandForAnyLesion() {
  const LabelSheet sheet =
      read(R"({"window_hu": [0, 1], "channels": ["background", "lesions", "portal_vein"]})");
  QVERIFY(sheet.finds(structure::kFirstLesion) && sheet.finds(structure::kFirstLesion + 7));
  QVERIFY(sheet.finds(structure::kPortalVein));
  QVERIFY(!sheet.finds(structure::kParenchyma) && !sheet.finds(structure::kBackground));
}

QTEST_APPLESS_MAIN(LabelSheetTest)
#include "label_sheet_test.moc"
