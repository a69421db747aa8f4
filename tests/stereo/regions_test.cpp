// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/regions.h"

#include <QtTest>

#include "glisson/core/error.h"
#include "glisson/core/files.h"

using namespace glisson;
using namespace glisson::stereo;

namespace {

Region square(Feature feature, double low, double high) {
  return {feature, {{low, low}, {high, low}, {high, high}, {low, high}}};
}

}  // namespace

class RegionsTest : public QObject {
  Q_OBJECT

  TemporaryFolder folder_;

 private slots:
  void WhatIsWrittenIsRead() {
    Regions regions;
    regions.frame = 17;
    regions.regions = {square(Feature::surface, 0.125, 100.5), square(Feature::anterior_margin, 10, 20),
                       square(Feature::umbilical_notch, 1.0 / 3.0, 2)};
    const auto path = folder_.path() / "regions.json";
    write_regions(path, regions);
    const Regions back = read_regions(path);
    QCOMPARE(back.frame, 17);
    QCOMPARE(back.regions.size(), std::size_t{3});
    for (std::size_t i = 0; i < 3; ++i) {
      QVERIFY(back.regions[i].feature == regions.regions[i].feature);
      QVERIFY(back.regions[i].polygon == regions.regions[i].polygon);
    }
  }

  void NotchGoesBeforeMarginBeforeSurface() {
    Regions regions;
    regions.regions = {square(Feature::umbilical_notch, 40, 60), square(Feature::surface, 0, 100),
                       square(Feature::anterior_margin, 30, 70)};
    QVERIFY(feature_at(regions, {50, 50}) == Feature::umbilical_notch);
    QVERIFY(feature_at(regions, {35, 50}) == Feature::anterior_margin);
    QVERIFY(feature_at(regions, {10, 50}) == Feature::surface);
    QVERIFY(!feature_at(regions, {110, 50}));
  }

  void HollowsOfAPolygonAreOutside() {
    Regions regions;
    regions.regions = {
        {Feature::surface, {{0, 0}, {10, 0}, {10, 10}, {8, 10}, {8, 2}, {2, 2}, {2, 10}, {0, 10}}}};
    QVERIFY(feature_at(regions, {1, 5}).has_value());
    QVERIFY(feature_at(regions, {9, 5}).has_value());
    QVERIFY(!feature_at(regions, {5, 5}).has_value());
  }

  void BadInputIsRefused_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QByteArray>("field");
    QTest::newRow("not JSON") << QByteArray("{") << QByteArray("line 1, column 2");
    QTest::newRow("a list") << QByteArray("[]") << QByteArray("regions");
    QTest::newRow("no regions") << QByteArray("{}") << QByteArray("regions");
    QTest::newRow("right image") << QByteArray(R"({"image": "right", "regions": []})") << QByteArray("image");
    QTest::newRow("odd frame") << QByteArray(R"({"frame": -1, "regions": []})") << QByteArray("frame");
    QTest::newRow("no label") << QByteArray(R"({"regions": [{"polygon": [[0,0],[1,0],[1,1]]}]})")
                              << QByteArray("region 0");
    QTest::newRow("odd label") << QByteArray(
                                      R"({"regions": [{"label": "spleen", "polygon": [[0,0],[1,0],[1,1]]}]})")
                               << QByteArray("region 0");
    QTest::newRow("no polygon") << QByteArray(R"({"regions": [{"label": "surface"}]})")
                                << QByteArray("region 0");
    QTest::newRow("two vertices") << QByteArray(
                                         R"({"regions": [{"label": "surface", "polygon": [[0,0],[1,0]]}]})")
                                  << QByteArray("region 0");
    QTest::newRow("vertex of three")
        << QByteArray(
               R"({"regions": [{"label": "surface", "polygon": [[0,0],[1,0],[1,1]]}, {"label": "surface", "polygon": [[0,0,0]]}]})")
        << QByteArray("region 1");
    QTest::newRow("vertex of text")
        << QByteArray(R"({"regions": [{"label": "surface", "polygon": [["a",0],[1,0],[1,1]]}]})")
        << QByteArray("region 0");
  }
  void BadInputIsRefused() {
    QFETCH(QByteArray, content);
    QFETCH(QByteArray, field);
    const auto path = folder_.path() / "bad.json";
    write_file_atomically(path, content.toStdString());
    try {
      read_regions(path);
      QFAIL("read what is no regions file");
    } catch (const InputError& error) {
      QCOMPARE(QByteArray::fromStdString(error.field()), field);
      QVERIFY(!error.remedy().empty());
    }
  }

  void MissingFileIsAFileError() {
    QVERIFY_THROWS_EXCEPTION(FileError, read_regions(folder_.path() / "absent.json"));
  }

  void DegenerateRegionIsNotWritten() {
    Regions regions;
    regions.regions = {{Feature::surface, {{0, 0}, {1, 0}}}};
    QVERIFY_THROWS_EXCEPTION(PreconditionError, write_regions(folder_.path() / "never.json", regions));
    regions.regions = {{Feature::surface, {{0, 0}, {1, 0}, {std::nan(""), 1}}}};
    QVERIFY_THROWS_EXCEPTION(PreconditionError, write_regions(folder_.path() / "never.json", regions));
  }
};

QTEST_APPLESS_MAIN(RegionsTest)
#include "regions_test.moc"
