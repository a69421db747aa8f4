// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/cut_organ.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <memory>

using namespace glisson;

class CutOrganTest : public QObject {
  Q_OBJECT
 private slots:
  void ABoxThatLeavesTheImageIsCutWhereItLeaves_data() {
    QTest::addColumn<int>("axis");
    QTest::addColumn<bool>("at_the_end");
    for (int axis = 0; axis < 3; ++axis)
      for (const bool at_the_end : {false, true})
        QTest::addRow("axis %d, %s", axis, at_the_end ? "end" : "begin") << axis << at_the_end;
  }
  void ABoxThatLeavesTheImageIsCutWhereItLeaves() {
    QFETCH(int, axis);
    QFETCH(bool, at_the_end);
    VolumeGrid grid;
    grid.size = {20, 24, 30};
    grid.spacing_mm = {2.0, 3.0, 5.0};
    Eigen::Vector3i low(6, 7, 8), high(14, 15, 20);  // 8 x 8 x 12 voxels
    (at_the_end ? high : low)[axis] = at_the_end ? grid.size[axis] : 0;
    std::vector<std::uint8_t> organ(20UL * 24UL * 30UL, 0);
    for (int k = low[2]; k < high[2]; ++k)
      for (int j = low[1]; j < high[1]; ++j)
        for (int i = low[0]; i < high[0]; ++i) organ[static_cast<std::size_t>(i + 20 * (j + 24 * k))] = 1;
    const double faces[3] = {24.0 * 60.0, 60.0 * 16.0, 16.0 * 24.0};  // mm: the box's sides
    QCOMPARE(area_mm2(grid, image_cut(grid, organ)), faces[axis]);
    const std::string told = *cut_note(grid, image_cut(grid, organ));
    QCOMPARE(told_cut({"liver.small", told}), std::lround(1e-2 * faces[axis]));
    QCOMPARE(told, std::string("liver.cut_off ") + (axis == 0 ? "14" : axis == 1 ? "10" : "4"));
  }
  void AnOrganInsideIsWhole() {
    VolumeGrid grid;
    grid.size = {5, 5, 5};
    std::vector<std::uint8_t> organ(125, 0);
    organ[62] = 1;
    QCOMPARE(area_mm2(grid, image_cut(grid, organ)), 0.0);
    QVERIFY(!cut_note(grid, image_cut(grid, organ)));
    QCOMPARE(told_cut({"liver.small"}), 0L);
    organ[0] = 1;  // a corner touches three sides, with three square millimetres
    QCOMPARE(area_mm2(grid, image_cut(grid, organ)), 3.0);
    QVERIFY(!cut_note(grid, image_cut(grid, organ)));
  }

  /// A tilt that was resampled away leaves a wedge of one value, which reaches the image's border.
  void PaddingCutsAnOrganAsTheImagesEndDoes_data() {
    QTest::addColumn<int>("padding");
    QTest::addColumn<int>("between");  // the voxel before the padding
    QTest::addColumn<double>("spacing_mm");
    QTest::addColumn<bool>("is_ct");
    QTest::addColumn<bool>("is_cut");
    QTest::newRow("air's value") << -1024 << 60 << 1.5 << true << true;
    QTest::newRow("below air") << -2048 << 60 << 1.5 << true << true;
    QTest::newRow("interpolated") << -1024 << -480 << 1.5 << true << true;
    QTest::newRow("a voxel as thick as a wall") << -1024 << -480 << 5.0 << true << false;
    QTest::newRow("grey values that end at fat") << -100 << 60 << 1.5 << true << false;
    QTest::newRow("no CT") << -1024 << 60 << 1.5 << false << false;
  }
  void PaddingCutsAnOrganAsTheImagesEndDoes() {
    QFETCH(int, padding);
    QFETCH(int, between);
    QFETCH(double, spacing_mm);
    QFETCH(bool, is_ct);
    QFETCH(bool, is_cut);
    Image image = image_of(spacing_mm);
    image.modality = is_ct ? Modality::ct : Modality::other;
    std::vector<std::int16_t> voxels(kVoxels, 60);
    std::vector<std::uint8_t> organ(kVoxels, 0);
    for (int k = 0; k < kSide; ++k)
      for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i) {
          const auto at = static_cast<std::size_t>(image.grid.offset({i, j, k}));
          const int beyond = j - k / 2;  // from the wedge's last voxel
          if (beyond <= 0) voxels[at] = static_cast<std::int16_t>(padding);
          if (beyond == 1) voxels[at] = static_cast<std::int16_t>(between);
          organ[at] = i >= 10 && i < 20 && j < 25 && k >= 15 && k < 24 && voxels[at] == 60;
        }
    image.voxels = std::make_shared<const std::vector<std::int16_t>>(voxels);
    const auto cut = image_cut(image.grid, organ, &image);
    QVERIFY(image_cut(image.grid, organ).empty());
    // At each of nine heights the organ has a row of ten faces on the wedge, and one below each of five
    // steps.
    const double faces = is_cut ? 90.0 + 50.0 : 0.0;
    if (between == 60) QCOMPARE(area_mm2(image.grid, cut), faces * spacing_mm * spacing_mm);
    QCOMPARE(cut_note(image.grid, cut).has_value(), is_cut);
  }
  void AirAroundABodyAndGasInItCutNothing() {
    Image image = image_of(1.5);
    std::vector<std::int16_t> voxels(kVoxels, -1024);  // as clean as no air is
    std::vector<std::uint8_t> organ(kVoxels, 0);
    for (int k = 0; k < kSide; ++k)
      for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i) {
          const auto at = static_cast<std::size_t>(image.grid.offset({i, j, k}));
          const int depth = std::min({i, j, k, kSide - 1 - i, kSide - 1 - j, kSide - 1 - k}) - 3;
          const bool is_gas = i >= 18 && depth >= 4;
          if (depth >= 0 && !is_gas) voxels[at] = 60;
          organ[at] = depth >= 4 && !is_gas;
        }
    image.voxels = std::make_shared<const std::vector<std::int16_t>>(voxels);
    QVERIFY(image_cut(image.grid, organ, &image).empty());
  }

 private:
  static constexpr int kSide = 30;
  static constexpr std::size_t kVoxels = 27000;
  static Image image_of(double spacing_mm) {
    Image image;
    image.grid.size.setConstant(kSide);
    image.grid.spacing_mm.setConstant(spacing_mm);
    return image;
  }
};

QTEST_GUILESS_MAIN(CutOrganTest)
#include "cut_organ_test.moc"
