// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/label_difference.h"

#include <QTest>
#include <random>

#include "glisson/core/error.h"

using namespace glisson;

namespace {

VolumeGrid grid() {
  VolumeGrid grid;
  grid.size = {70, 40, 35};  // bricks that the volume does not fill
  return grid;
}

/// Balls of random labels.
LabelVolume random_labels(std::mt19937& random, LabelVolume labels, int balls, Label most) {
  const Eigen::Vector3i size = labels.grid().size;
  const auto upto = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int n = 0; n < balls; ++n) {
    const Eigen::Vector3i middle(upto(size.x()), upto(size.y()), upto(size.z()));
    const int radius = 2 + upto(8);
    const auto label = static_cast<Label>(upto(most + 1));
    for (int k = -radius; k <= radius; ++k)
      for (int j = -radius; j <= radius; ++j)
        for (int i = -radius; i <= radius; ++i) {
          const Eigen::Vector3i v = middle + Eigen::Vector3i(i, j, k);
          if (labels.grid().contains(v) && i * i + j * j + k * k <= radius * radius) labels.set(v, label);
        }
  }
  return labels;
}

}  // namespace

class LabelDifferenceTest : public QObject {
  Q_OBJECT
 private slots:
  void DifferenceIsThatOfEveryVoxelCountedByItself();
  void WhatAHandCorrectedStaysAndAllElseIsTaken();
  void MostIsShownWhereAHandsVoxelsChange();
  void NothingChangesBetweenTheSame();
  void OneGridIsRequired();
};

void LabelDifferenceTest::DifferenceIsThatOfEveryVoxelCountedByItself() {
  std::mt19937 random(1);
  long all = 0, of_hand = 0;
  for (int trial = 0; trial < 5; ++trial) {
    const LabelVolume mine = random_labels(random, LabelVolume(grid()), 12, 4);
    const LabelVolume offered = random_labels(random, mine, 6, 5);
    const LabelVolume hand = random_labels(random, LabelVolume(grid()), 25, 1);
    LabelDifference naive;
    std::map<int, long> layers;
    const auto was = mine.dense(), will = offered.dense(), marked = hand.dense();
    for (std::size_t n = 0; n < was.size(); ++n) {
      naive.hand_voxels += marked[n] != 0;
      if (was[n] == will[n]) continue;
      ++naive.voxels_changed;
      naive.hand_changed += marked[n] != 0;
      if (was[n] != 0) ++naive.labels[was[n]].lost;
      if (will[n] != 0) ++naive.labels[will[n]].gained;
      if (marked[n] != 0) ++layers[static_cast<int>(n) / (70 * 40)];
    }
    const LabelDifference told = label_difference(mine, offered, hand);
    QVERIFY(told.labels == naive.labels);
    QCOMPARE(told.voxels_changed, naive.voxels_changed);
    QCOMPARE(told.hand_voxels, naive.hand_voxels);
    QCOMPARE(told.hand_changed, naive.hand_changed);
    all += naive.voxels_changed;
    of_hand += naive.hand_changed;
    if (naive.hand_changed == 0) continue;
    const Eigen::Vector3i at = told.where_most.value();
    QVERIFY(mine.at(at) != offered.at(at) && hand.at(at) != 0);
    for (const auto& [layer, count] : layers) QVERIFY(count <= layers[at.z()]);
  }
  QVERIFY(of_hand > 0 && of_hand < all);
}

void LabelDifferenceTest::WhatAHandCorrectedStaysAndAllElseIsTaken() {
  std::mt19937 random(2);
  const LabelVolume mine = random_labels(random, LabelVolume(grid()), 12, 4);
  const LabelVolume offered = random_labels(random, LabelVolume(grid()), 12, 4);
  const LabelVolume hand = random_labels(random, LabelVolume(grid()), 25, 1);
  const auto kept = keeping_hand(mine, offered, hand).dense();
  const auto was = mine.dense(), will = offered.dense(), marked = hand.dense();
  for (std::size_t n = 0; n < kept.size(); ++n) QCOMPARE(kept[n], marked[n] != 0 ? was[n] : will[n]);
  const LabelDifference left = label_difference(mine, keeping_hand(mine, offered, hand), hand);
  QCOMPARE(left.hand_changed, 0L);
  QVERIFY(left.voxels_changed > 0);
}

void LabelDifferenceTest::MostIsShownWhereAHandsVoxelsChange() {
  const LabelVolume mine(grid());
  LabelVolume offered = mine, hand = mine;
  for (int i = 0; i < 30; ++i) offered.set({i, 3, 4}, 1);  // more, but none of a hand's
  for (int i = 0; i < 5; ++i) {
    offered.set({i, 9, 20}, 1);
    hand.set({i, 9, 20}, 1);
  }
  QCOMPARE(label_difference(mine, offered, hand).where_most.value(), Eigen::Vector3i(2, 9, 20));
  QCOMPARE(label_difference(mine, offered, mine).where_most.value().z(), 4);
}

void LabelDifferenceTest::NothingChangesBetweenTheSame() {
  std::mt19937 random(3);
  const LabelVolume mine = random_labels(random, LabelVolume(grid()), 12, 4);
  const LabelVolume same(grid(), mine.dense());  // equal, not shared
  const LabelDifference none = label_difference(mine, same, LabelVolume(grid()));
  QVERIFY(none.labels.empty() && !none.where_most);
  QCOMPARE(none.voxels_changed + none.hand_voxels + none.hand_changed, 0L);
}

void LabelDifferenceTest::OneGridIsRequired() {
  VolumeGrid other = grid();
  other.size.x() += 1;
  const LabelVolume mine(grid());
  QVERIFY_THROWS_EXCEPTION(PreconditionError, label_difference(mine, LabelVolume(other), mine));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, keeping_hand(mine, mine, LabelVolume(other)));
}

QTEST_APPLESS_MAIN(LabelDifferenceTest)
#include "label_difference_test.moc"
