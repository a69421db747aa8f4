// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/cut_organ.h"

#include <QTest>
#include <cmath>

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
    QCOMPARE(cut_area_mm2(grid, organ), faces[axis]);
    const std::string told = *cut_note(grid, organ);
    QCOMPARE(told_cut({"liver.small", told}), std::lround(1e-2 * faces[axis]));
    QCOMPARE(told, std::string("liver.cut_off ") + (axis == 0 ? "14" : axis == 1 ? "10" : "4"));
  }
  void AnOrganInsideIsWhole() {
    VolumeGrid grid;
    grid.size = {5, 5, 5};
    std::vector<std::uint8_t> organ(125, 0);
    organ[62] = 1;
    QCOMPARE(cut_area_mm2(grid, organ), 0.0);
    QVERIFY(!cut_note(grid, organ));
    QCOMPARE(told_cut({"liver.small"}), 0L);
    organ[0] = 1;  // a corner touches three sides, with three square millimetres
    QCOMPARE(cut_area_mm2(grid, organ), 3.0);
    QVERIFY(!cut_note(grid, organ));
  }
};

QTEST_GUILESS_MAIN(CutOrganTest)
#include "cut_organ_test.moc"
