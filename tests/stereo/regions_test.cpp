// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/regions.h"

#include <QTest>

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

  void CurvesSidesAndIdentityAreKept() {
    Regions regions;
    regions.identity = "0123456789abcdef";
    regions.regions = {
        square(Feature::surface, 0, 100),
        {Feature::anterior_margin, {{0, 90}, {50.25, 95}, {100, 90}}, false, 7.5, Side::right}};
    write_regions(folder_.path() / "curve.json", regions);
    const Regions back = read_regions(folder_.path() / "curve.json");
    QCOMPARE(back.identity, regions.identity);
    QVERIFY(back.regions[0].closed && back.regions[0].side == Side::left);
    QVERIFY(!back.regions[1].closed && back.regions[1].side == Side::right);
    QCOMPARE(back.regions[1].half_width_px, 7.5);
    QVERIFY(back.regions[1].polygon == regions.regions[1].polygon);
  }

  void FilesOfEarlierVersionsAreRead() {
    write_file_atomically(
        folder_.path() / "old.json",
        R"({"image": "left", "frame": 3, "regions": [{"label": "surface", "polygon": [[0,0],[9,0],[9,9]]}]})");
    const Regions old = read_regions(folder_.path() / "old.json");
    QCOMPARE(old.frame, 3);
    QVERIFY(old.identity.empty() && old.regions[0].closed && old.regions[0].side == Side::left);
    const Picture some{1, 1, 1, std::make_shared<std::vector<std::uint8_t>>(1)};
    require_regions_of(old, some, some);  // nothing is known: nothing is refused
  }

  void CurveReachesItsHalfWidthAndIsOpen() {
    Regions regions;
    regions.regions = {{Feature::anterior_margin, {{10, 10}, {90, 10}, {90, 90}}, false, 5.0}};
    QVERIFY(feature_at(regions, {50, 14.9}).has_value());
    QVERIFY(!feature_at(regions, {50, 15.1}).has_value());
    QVERIFY(!feature_at(regions, {50, 50}).has_value());  // the way back from the last vertex to the first
    QVERIFY(!feature_at(regions, {4, 10}).has_value());   // beyond its end
  }

  void RegionsCountOnTheirOwnPicture() {
    Regions regions;
    regions.regions = {square(Feature::surface, 0, 10)};
    regions.regions[0].side = Side::right;
    QVERIFY(!feature_at(regions, {5, 5}));
    QVERIFY(feature_at(regions, Side::right, {5, 5}) == Feature::surface);
  }

  void RegionsOfAnotherFrameAreRefused() {
    const auto picture = [](int width, int height, std::uint8_t first) {
      auto bytes = std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(width * height), 7);
      bytes->front() = first;
      return Picture{width, height, 1, std::move(bytes)};
    };
    const Picture a = picture(5, 3, 1), b = picture(5, 3, 2), c = picture(3, 5, 1);
    Regions regions;
    regions.identity = frame_identity(a, b);
    regions.regions = {square(Feature::surface, 0, 10)};
    require_regions_of(regions, a, b);
    QVERIFY_THROWS_EXCEPTION(InputError, require_regions_of(regions, b, a));
    QVERIFY_THROWS_EXCEPTION(InputError, require_regions_of(regions, a, a));
    QVERIFY(frame_identity(a, b) != frame_identity(c, b));
  }

  void OutlineIsMetWhereItIsClosest() {
    const Region region = square(Feature::surface, 0, 10);
    const OutlinePlace on_last = closest_on_outline(region, {-2, 5});
    QCOMPARE(on_last.edge, std::size_t{3});
    QCOMPARE(on_last.distance_px, 2.0);
    QVERIFY(on_last.pixel == Eigen::Vector2d(0, 5));
    Region curve = region;
    curve.closed = false;
    QCOMPARE(closest_on_outline(curve, {-2, 5}).edge, std::size_t{0});
    QVERIFY_THROWS_EXCEPTION(PreconditionError, closest_on_outline(Region{}, {0, 0}));
  }

  void CrossingEdgesAreFound() {
    QVERIFY(!crosses_itself(square(Feature::surface, 0, 10)));
    QVERIFY(crosses_itself({Feature::surface, {{0, 0}, {10, 10}, {10, 0}, {0, 10}}}));
    QVERIFY(crosses_itself({Feature::anterior_margin, {{0, 0}, {10, 10}, {10, 0}, {0, 10}}, false}));
    // Only the way back crosses: a curve has none.
    const std::vector<Eigen::Vector2d> hook = {{0, 0}, {10, 0}, {10, 10}, {5, 10}, {5, -5}, {6, -5}};
    QVERIFY(crosses_itself({Feature::surface, hook}));
    const std::vector<Eigen::Vector2d> bowl = {{0, 0}, {10, 10}, {20, 0}, {20, 5}};
    QVERIFY(crosses_itself({Feature::surface, bowl}));
    QVERIFY(!crosses_itself({Feature::anterior_margin, bowl, false}));
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
    QTest::newRow("curve of one vertex")
        << QByteArray(R"({"regions": [{"label": "anterior_margin", "curve": [[0,0]]}]})")
        << QByteArray("region 0");
    QTest::newRow("curve without width")
        << QByteArray(R"({"regions": [{"label": "surface", "curve": [[0,0],[1,0]], "half_width_px": 0}]})")
        << QByteArray("region 0");
    QTest::newRow("far outside")
        << QByteArray(R"({"regions": [{"label": "surface", "polygon": [[0,0],[1e300,0],[1,1]]}]})")
        << QByteArray("region 0");
    QTest::newRow("endless width")
        << QByteArray(
               R"({"regions": [{"label": "surface", "curve": [[0,0],[1,0]], "half_width_px": 1e300}]})")
        << QByteArray("region 0");
    QTest::newRow("larger than any number")
        << QByteArray(R"({"regions": [{"label": "surface", "polygon": [[0,0],[1e999,0],[1,1]]}]})")
        << QByteArray("");
    QTest::newRow("region of no picture")
        << QByteArray(
               R"({"regions": [{"label": "surface", "image": "top", "polygon": [[0,0],[1,0],[1,1]]}]})")
        << QByteArray("region 0");
    QTest::newRow("odd identity") << QByteArray(R"({"identity": "xyz", "regions": []})")
                                  << QByteArray("identity");
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
    regions.regions = {{Feature::surface, {{0, 0}}, false}};
    QVERIFY_THROWS_EXCEPTION(PreconditionError, write_regions(folder_.path() / "never.json", regions));
    regions.regions = {{Feature::surface, {{0, 0}, {1, 0}}, false, 0.0}};
    QVERIFY_THROWS_EXCEPTION(PreconditionError, write_regions(folder_.path() / "never.json", regions));
    regions.regions = {{Feature::surface, {{0, 0}, {1, 0}, {std::nan(""), 1}}}};
    QVERIFY_THROWS_EXCEPTION(PreconditionError, write_regions(folder_.path() / "never.json", regions));
  }
};

QTEST_APPLESS_MAIN(RegionsTest)
#include "regions_test.moc"
