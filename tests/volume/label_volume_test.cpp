// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/volume/label_volume.h"

#include <QTest>

#include "glisson/core/error.h"

using namespace glisson;

namespace {

VolumeGrid grid_of(int x, int y, int z) {
  VolumeGrid grid;
  grid.size = {x, y, z};
  return grid;
}

/// Sizes that are smaller than, equal to and just above a brick.
const VolumeGrid kGrid = grid_of(70, 32, 33);

Eigen::Vector3i random_voxel(const VolumeGrid& grid, std::mt19937& random) {
  return {static_cast<int>(random() % static_cast<unsigned>(grid.size.x())),
          static_cast<int>(random() % static_cast<unsigned>(grid.size.y())),
          static_cast<int>(random() % static_cast<unsigned>(grid.size.z()))};
}

}  // namespace

class LabelVolumeTest : public QObject {
  Q_OBJECT
 private slots:
  void AgreesWithAPlainArrayUnderRandomEdits();
  void CopiesKeepWhatTheyHeld();
  void CopySharesAndWriteCopiesOneBrick();
  void DenseGoesThereAndBack();
  void MaskAndHistogramCount();
  void EqualityLooksAtContentNotAtSharing();
  void RefusesVoxelsOutsideAndWrongSizes();
};

void LabelVolumeTest::AgreesWithAPlainArrayUnderRandomEdits() {
  std::mt19937 random(7);
  LabelVolume volume(kGrid);
  std::vector<Label> plain(static_cast<std::size_t>(kGrid.voxel_count()), 0);
  std::vector<std::pair<LabelVolume, std::vector<Label>>> history;
  for (int step = 0; step < 20000; ++step) {
    const Eigen::Vector3i v = random_voxel(kGrid, random);
    const auto label = static_cast<Label>(random() % 5 == 0 ? 0 : random() % 400);
    volume.set(v, label);
    plain[static_cast<std::size_t>(kGrid.offset(v))] = label;
    if (step % 4000 == 0) history.emplace_back(volume, plain);
    const Eigen::Vector3i w = random_voxel(kGrid, random);
    if (volume.at(w) != plain[static_cast<std::size_t>(kGrid.offset(w))]) QFAIL("a voxel differs");
  }
  QCOMPARE(volume.dense(), plain);
  for (const auto& [then, values] : history) QCOMPARE(then.dense(), values);
}

void LabelVolumeTest::CopiesKeepWhatTheyHeld() {
  LabelVolume volume(kGrid);
  volume.set({1, 2, 3}, 5);
  const LabelVolume before = volume;
  volume.set({1, 2, 3}, 6);
  volume.set({1, 2, 4}, 7);
  QCOMPARE(before.at({1, 2, 3}), Label(5));
  QCOMPARE(before.at({1, 2, 4}), Label(0));
  QCOMPARE(volume.at({1, 2, 3}), Label(6));
}

void LabelVolumeTest::CopySharesAndWriteCopiesOneBrick() {
  std::vector<Label> ones(static_cast<std::size_t>(kGrid.voxel_count()), 1);
  const LabelVolume volume(kGrid, ones);
  LabelVolume copy = volume;
  QCOMPARE(copy.bricks_differing_from(volume), 0);
  copy.set({40, 3, 3}, 2);
  QCOMPARE(copy.bricks_differing_from(volume), 1);
  copy.set({41, 4, 5}, 2);  // the same brick
  QCOMPARE(copy.bricks_differing_from(volume), 1);
  copy.set({0, 0, 32}, 2);
  QCOMPARE(copy.bricks_differing_from(volume), 2);
  copy.set({0, 0, 0}, 1);  // what it is already: nothing to copy
  QCOMPARE(copy.bricks_differing_from(volume), 2);
}

void LabelVolumeTest::DenseGoesThereAndBack() {
  std::mt19937 random(3);
  std::vector<Label> values(static_cast<std::size_t>(kGrid.voxel_count()));
  for (Label& value : values) value = static_cast<Label>(random());
  QCOMPARE(LabelVolume(kGrid, values).dense(), values);
}

void LabelVolumeTest::MaskAndHistogramCount() {
  LabelVolume volume(kGrid);
  volume.set({69, 31, 32}, 9);
  volume.set({0, 0, 0}, 9);
  volume.set({33, 1, 1}, 2);
  const std::vector<long> counts = volume.histogram();
  QCOMPARE(counts.size(), std::size_t(10));
  QCOMPARE(counts[9], 2L);
  QCOMPARE(counts[2], 1L);
  QCOMPARE(counts[0], kGrid.voxel_count() - 3);
  const auto nines = volume.mask([](Label label) { return label == 9; });
  QCOMPARE(std::count(nines.begin(), nines.end(), std::uint8_t(1)), std::ptrdiff_t(2));
  QVERIFY(nines.back() == 1 && nines.front() == 1);
  const auto zeros = volume.mask([](Label label) { return label == 0; });
  QCOMPARE(std::count(zeros.begin(), zeros.end(), std::uint8_t(1)), std::ptrdiff_t(kGrid.voxel_count() - 3));
}

void LabelVolumeTest::EqualityLooksAtContentNotAtSharing() {
  LabelVolume a(kGrid), b(kGrid);
  QVERIFY(a == b);
  a.set({5, 5, 5}, 1);
  QVERIFY(!(a == b));
  b.set({5, 5, 5}, 1);
  QVERIFY(a == b);
  a.set({5, 5, 5}, 0);
  QVERIFY(a == LabelVolume(kGrid));  // an allocated brick of zeros is no brick
  VolumeGrid moved = kGrid;
  moved.origin_mm.x() = 1.0;
  QVERIFY(!(LabelVolume(moved) == LabelVolume(kGrid)));
}

void LabelVolumeTest::RefusesVoxelsOutsideAndWrongSizes() {
  LabelVolume volume(kGrid);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, volume.set({70, 0, 0}, 1));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, volume.set({0, -1, 0}, 1));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, (void)volume.at({0, 0, 33}));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, LabelVolume(kGrid, std::vector<Label>(3)));
  QVERIFY_THROWS_EXCEPTION(PreconditionError,
                           (void)volume.bricks_differing_from(LabelVolume(grid_of(1, 1, 1))));
}

QTEST_APPLESS_MAIN(LabelVolumeTest)
#include "label_volume_test.moc"
