// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiles.h"

#include <QTest>
#include <cmath>

using namespace glisson;
using namespace glisson::network;

class TilesTest : public QObject {
  Q_OBJECT
 private slots:
  void TilesReachFromEndToEndAndOverlap();
  void BlendedConstantsStayWhatTheyAre();
  void WhatATileGetsWrongAtItsBorderCountsLittle();
  void AxesAreTurnedAndFlippedToWhatIsAsked();
  void PlacesGoThereAndBack();
};

void TilesTest::TilesReachFromEndToEndAndOverlap() {
  for (const int size : {1, 7, 16, 17, 40, 101})
    for (const double overlap : {0.0, 0.25, 0.5, 0.9}) {
      const int tile = 16;
      const auto starts = tile_starts(size, tile, overlap);
      QCOMPARE(starts.front(), 0);
      QVERIFY(size <= tile ? starts.size() == 1 : starts.back() + tile == size);
      for (std::size_t n = 1; n < starts.size(); ++n) {
        const int shared = starts[n - 1] + tile - starts[n];
        QVERIFY(shared >= static_cast<int>(overlap * tile) && starts[n] > starts[n - 1]);
      }
    }
}

namespace {

/// All tiles of a volume through a blend. @param score of a voxel within its tile, and in the volume
template <class Score>
std::vector<std::vector<float>> blended(const Three& size, const Three& tile, double overlap,
                                        const Score& score) {
  std::array<std::vector<int>, 3> starts;
  for (std::size_t n = 0; n < 3; ++n) starts[n] = tile_starts(size[n], tile[n], overlap);
  TileBlend blend(size, tile, starts, 1);
  std::vector<std::vector<float>> slices;
  for (const int slice : starts[0]) {
    while (static_cast<int>(slices.size()) < slice)
      slices.push_back(blend.take(static_cast<int>(slices.size())));
    for (const int row : starts[1])
      for (const int column : starts[2]) {
        std::vector<float> scores;
        for (int k = 0; k < tile[0]; ++k)
          for (int j = 0; j < tile[1]; ++j)
            for (int i = 0; i < tile[2]; ++i)
              scores.push_back(score(Three{k, j, i}, Three{slice + k, row + j, column + i}));
        blend.add({slice, row, column}, scores);
      }
  }
  while (static_cast<int>(slices.size()) < size[0])
    slices.push_back(blend.take(static_cast<int>(slices.size())));
  return slices;
}

}  // namespace

void TilesTest::BlendedConstantsStayWhatTheyAre() {
  const Three size = {9, 20, 33};
  const auto value = [](const Three& at) { return static_cast<float>(100 * at[0] + 10 * at[1] + at[2]); };
  const auto slices =
      blended(size, {4, 8, 16}, 0.5, [&](const Three&, const Three& at) { return value(at); });
  for (int k = 0; k < size[0]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[2]; ++i) {
        const float is = slices[static_cast<std::size_t>(k)][static_cast<std::size_t>(j * size[2] + i)];
        QVERIFY(std::abs(is - value({k, j, i})) < 1e-3F);
      }
}

void TilesTest::WhatATileGetsWrongAtItsBorderCountsLittle() {
  // Each tile is wrong by 1 at its outermost columns. Where another one's middle lies over them, little is
  // left.
  const int tile = 16;
  const auto wrong = [&](const Three& in_tile, const Three&) {
    return in_tile[2] == 0 || in_tile[2] == tile - 1 ? 1.0F : 0.0F;
  };
  const auto slices = blended({1, 1, 64}, {1, 1, tile}, 0.5, wrong);
  float most = 0.0F;
  for (int i = 1; i < 63; ++i) most = std::max(most, slices[0][static_cast<std::size_t>(i)]);
  QVERIFY(most > 0.0F && most < 0.13F);
  const auto apart = blended({1, 1, 64}, {1, 1, tile}, 0.0, wrong);
  QCOMPARE(apart[0][tile], 1.0F);  // nobody else knows better
}

void TilesTest::AxesAreTurnedAndFlippedToWhatIsAsked() {
  // Stored as sagittal slices: i to the head, j to the front, k to the right.
  VolumeGrid grid;
  grid.size = {3, 4, 5};
  grid.direction.col(0) = Eigen::Vector3d(0, 0.05, 1).normalized();
  grid.direction.col(1) = -Eigen::Vector3d::UnitY();
  grid.direction.col(2) = -Eigen::Vector3d::UnitX();
  const Oriented oriented(grid, "SPL", {});
  QVERIFY((oriented.size() == Three{3, 4, 5}));
  QCOMPARE(oriented.offset(0, 0, 0), static_cast<std::size_t>(grid.offset({0, 3, 4})));
  QCOMPARE(oriented.offset(2, 1, 3), static_cast<std::size_t>(grid.offset({2, 2, 1})));
  const Oriented other(grid, "LAI", {});
  QVERIFY((other.size() == Three{5, 4, 3}));
  QCOMPARE(other.offset(0, 0, 0), static_cast<std::size_t>(grid.offset({2, 0, 4})));
}

void TilesTest::PlacesGoThereAndBack() {
  VolumeGrid grid;
  grid.size = {30, 20, 10};
  grid.spacing_mm = {0.8, 0.8, 3.0};
  const Oriented oriented(grid, "SPL", {1.5, 1.6, 1.6});
  QVERIFY((oriented.size() == Three{20, 10, 15}));
  for (int axis = 0; axis < 3; ++axis)
    QVERIFY(std::abs(oriented.network_place(axis, oriented.volume_place(axis, 4.0)) - 4.0) < 1e-9);
  QCOMPARE(oriented.volume_place(1, 0.0), 0.5);  // the middle of two voxels
  const Oriented slices(grid, "SPL", {1.6, 1.6});
  QVERIFY((slices.size() == Three{10, 10, 15}));
}

QTEST_APPLESS_MAIN(TilesTest)
#include "tiles_test.moc"
