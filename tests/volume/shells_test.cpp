// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/volume/shells.h"

#include <QTest>

using namespace glisson;

namespace {

VolumeGrid cube_of(int side, double slice_mm) {
  VolumeGrid grid;
  grid.size.setConstant(side);
  grid.spacing_mm = {1.0, 1.0, slice_mm};
  return grid;
}

/// Voxels that touch each other at corners only.
std::vector<std::uint8_t> diagonal(const VolumeGrid& grid, int first, int last) {
  std::vector<std::uint8_t> tree(static_cast<std::size_t>(grid.voxel_count()), 0);
  for (int i = first; i <= last; ++i) tree[static_cast<std::size_t>(grid.offset({i, i, i}))] = 1;
  return tree;
}

}  // namespace

class ShellsTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatIsJoinedAtCornersHangsOnTheRoot_data();
  void WhatIsJoinedAtCornersHangsOnTheRoot();
  void AForkHasItsBranches();
};

void ShellsTest::WhatIsJoinedAtCornersHangsOnTheRoot_data() {
  QTest::addColumn<double>("slice_mm");
  for (const double mm : {0.7, 1.0, 1.2, 1.5, 2.0}) QTest::addRow("%.1f", mm) << mm;
}

void ShellsTest::WhatIsJoinedAtCornersHangsOnTheRoot() {
  QFETCH(const double, slice_mm);
  const VolumeGrid grid = cube_of(40, slice_mm);
  const Shells shells = shells_of(grid, diagonal(grid, 2, 37), Eigen::Vector3d(2, 2, 2));
  QCOMPARE(shells.pieces.front().parent, -1);
  for (std::size_t n = 1; n < shells.pieces.size(); ++n) {
    QVERIFY(shells.pieces[n].parent >= 0);
    QVERIFY(shells.pieces[n].parent < static_cast<int>(n));
  }
  QCOMPARE(shells.beyond(0).size(), shells.pieces.size());
  QCOMPARE(shells.pieces.front().height, static_cast<int>(shells.pieces.size()) - 1);
  QCOMPARE(shells.loops, 0);
}

void ShellsTest::AForkHasItsBranches() {
  const VolumeGrid grid = cube_of(40, 1.0);
  std::vector<std::uint8_t> tree = diagonal(grid, 2, 20);
  for (int n = 1; n <= 15; ++n) {
    tree[static_cast<std::size_t>(grid.offset({20 + n, 20, 20}))] = 1;
    tree[static_cast<std::size_t>(grid.offset({20, 20 + n, 20}))] = 1;
  }
  const Shells shells = shells_of(grid, tree, Eigen::Vector3d(2, 2, 2));
  int forks = 0;
  for (std::size_t n = 0; n < shells.pieces.size(); ++n)
    forks += shells.branches_of(static_cast<int>(n)).size() == 2 ? 1 : 0;
  QCOMPARE(forks, 1);
  QCOMPARE(shells.loops, 0);
}

QTEST_APPLESS_MAIN(ShellsTest)
#include "shells_test.moc"
