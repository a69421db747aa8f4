// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/volume/morphology.h"

#include <QTest>

#include "glisson/core/error.h"

using namespace glisson;

namespace {

Mask random_mask(const Eigen::Vector3i& size, const Eigen::Vector3d& spacing, int one_in, unsigned seed) {
  Mask mask(size, spacing);
  std::mt19937 random(seed);
  for (auto& v : mask.voxels) v = random() % static_cast<unsigned>(one_in) == 0;
  return mask;
}

template <class Visit>
void each(const Mask& mask, Visit&& visit) {
  for (int k = 0; k < mask.size.z(); ++k)
    for (int j = 0; j < mask.size.y(); ++j)
      for (int i = 0; i < mask.size.x(); ++i) visit(Eigen::Vector3i(i, j, k), mask.offset(i, j, k));
}

}  // namespace

class MorphologyTest : public QObject {
  Q_OBJECT
 private slots:
  void DistanceAgreesWithBruteForce();
  void DistanceOfNothingIsInfinite();
  void DilationAndErosionAgreeWithBruteForce();
  void ClosingFillsANarrowGapAndKeepsAWideOne();
  void ClosingDoesNotDependOnWhereTheVolumeEnds();
  void ComponentsAreRankedBySize();
  void HolesAreFilledAndBaysAreNot();
  void CropAndPasteGoThereAndBack();
  void CropOutsideIsRefused();
};

void MorphologyTest::DistanceAgreesWithBruteForce() {
  for (const int one_in : {3, 40, 300}) {
    const Mask mask = random_mask({13, 9, 11}, {0.7, 1.9, 3.1}, one_in, 5);
    if (mask.count() == 0) QFAIL("the example is empty");
    const std::vector<float> distance = squared_distance_mm2(mask);
    each(mask, [&](const Eigen::Vector3i& a, std::size_t at) {
      double best = 1e30;
      each(mask, [&](const Eigen::Vector3i& b, std::size_t other) {
        if (mask.voxels[other] != 0)
          best = std::min(best, (a - b).cast<double>().cwiseProduct(mask.spacing_mm).squaredNorm());
      });
      QVERIFY(std::abs(best - distance[at]) <= 1e-5 * std::max(1.0, best));
    });
    const std::vector<float> depth = squared_depth_mm2(mask);
    const Mask rest = complement(mask);
    each(mask, [&](const Eigen::Vector3i& a, std::size_t at) {
      QCOMPARE(rest.voxels[at] != 0, mask.voxels[at] == 0);
      double best = 1e30;
      each(mask, [&](const Eigen::Vector3i& b, std::size_t other) {
        if (mask.voxels[other] == 0)
          best = std::min(best, (a - b).cast<double>().cwiseProduct(mask.spacing_mm).squaredNorm());
      });
      QVERIFY(std::abs(best - depth[at]) <= 1e-5 * std::max(1.0, best));
    });
  }
}

void MorphologyTest::DistanceOfNothingIsInfinite() {
  const std::vector<float> distance = squared_distance_mm2(Mask({3, 4, 5}, {1, 1, 1}));
  QVERIFY(std::all_of(distance.begin(), distance.end(), [](float d) { return std::isinf(d); }));
}

void MorphologyTest::DilationAndErosionAgreeWithBruteForce() {
  // Half of the voxels, few of them, and all but few: what is far from a mask's border is not looked at.
  const Mask few = random_mask({12, 10, 8}, {1.0, 1.5, 2.0}, 400, 3);
  QVERIFY(few.count() > 0 && few.count() < 6);
  for (const Mask& mask : {random_mask({12, 10, 8}, {1.0, 1.5, 2.0}, 2, 11), few, complement(few)})
    for (const double radius : {2.0, 3.1}) {
      const Mask grown = dilated(mask, radius), shrunk = eroded(mask, radius);
      each(mask, [&](const Eigen::Vector3i& a, std::size_t at) {
        bool any = false, all = true;
        each(mask, [&](const Eigen::Vector3i& b, std::size_t other) {
          if ((a - b).cast<double>().cwiseProduct(mask.spacing_mm).norm() > radius + 1e-9) return;
          any = any || mask.voxels[other] != 0;
          all = all && mask.voxels[other] != 0;
        });
        QCOMPARE(grown.voxels[at] != 0, any);
        QCOMPARE(shrunk.voxels[at] != 0, all);
      });
    }
}

void MorphologyTest::ClosingFillsANarrowGapAndKeepsAWideOne() {
  Mask mask({60, 20, 20}, {1, 1, 1});
  // Two slabs and a third: gaps of 3 and of 15 voxels.
  each(mask, [&](const Eigen::Vector3i& v, std::size_t at) {
    const bool slab =
        (v.x() >= 10 && v.x() < 20) || (v.x() >= 23 && v.x() < 33) || (v.x() >= 48 && v.x() < 55);
    mask.voxels[at] = slab ? 1 : 0;
  });
  const Mask result = closed(mask, 3.0);
  QCOMPARE(int(result.voxels[result.offset(21, 10, 10)]), 1);
  QCOMPARE(int(result.voxels[result.offset(40, 10, 10)]), 0);
  QCOMPARE(int(result.voxels[result.offset(57, 10, 10)]), 0);
}

void MorphologyTest::ClosingDoesNotDependOnWhereTheVolumeEnds() {
  // A ball with a notch; the volume ends at its sides, or far from them.
  const auto ball = [](int room) {
    Mask mask(Eigen::Vector3i::Constant(21 + 2 * room), {1.0, 1.0, 1.5});
    each(mask, [&](const Eigen::Vector3i& v, std::size_t at) {
      const Eigen::Vector3i p = v - Eigen::Vector3i::Constant(10 + room);
      const bool notch = p.x() > 4 && std::abs(p.y()) < 2;
      mask.voxels[at] = p.squaredNorm() <= 100 && !notch ? 1 : 0;
    });
    return mask;
  };
  constexpr int kRoom = 25;
  const Mask near = closed(ball(0), 12.0), far = closed(ball(kRoom), 12.0);
  QVERIFY(near.count() > ball(0).count());
  QCOMPARE(near.count(), far.count());
  each(near, [&](const Eigen::Vector3i& v, std::size_t at) {
    QCOMPARE(int(near.voxels[at]), int(far.voxels[far.offset(v.x() + kRoom, v.y() + kRoom, v.z() + kRoom)]));
  });
}

void MorphologyTest::ComponentsAreRankedBySize() {
  Mask mask({10, 10, 10}, {1, 1, 1});
  mask.voxels[mask.offset(0, 0, 0)] = 1;
  for (int i = 2; i < 9; ++i) mask.voxels[mask.offset(i, 5, 5)] = 1;
  mask.voxels[mask.offset(9, 6, 5)] = 1;  // touches the line by an edge only
  std::vector<long> sizes;
  const std::vector<int> number = connected_components(mask, sizes);
  QCOMPARE(sizes, (std::vector<long>{7, 1, 1}));
  QCOMPARE(number[mask.offset(4, 5, 5)], 1);
  QCOMPARE(number[mask.offset(0, 1, 0)], 0);
  QCOMPARE(largest_component(mask).count(), 7L);
}

void MorphologyTest::HolesAreFilledAndBaysAreNot() {
  Mask mask({9, 9, 9}, {1, 1, 1});
  each(mask, [&](const Eigen::Vector3i& v, std::size_t at) {
    mask.voxels[at] = ((v.array() >= 1) && (v.array() <= 7)).all();
  });
  mask.voxels[mask.offset(3, 3, 3)] = 0;                              // a hole
  for (int k = 0; k < 6; ++k) mask.voxels[mask.offset(5, 5, k)] = 0;  // a bay, open below
  const Mask filled = holes_filled(mask);
  QCOMPARE(int(filled.voxels[filled.offset(3, 3, 3)]), 1);
  QCOMPARE(int(filled.voxels[filled.offset(5, 5, 4)]), 0);
  const Mask by_slice = slice_holes_filled(mask);
  QCOMPARE(int(by_slice.voxels[by_slice.offset(5, 5, 4)]), 1);  // enclosed within its slice
  QCOMPARE(int(by_slice.voxels[by_slice.offset(5, 5, 0)]), 0);
}

void MorphologyTest::CropAndPasteGoThereAndBack() {
  Mask mask({12, 11, 10}, {1, 2, 3});
  mask.voxels[mask.offset(5, 5, 5)] = 1;
  mask.voxels[mask.offset(7, 6, 5)] = 1;
  const VoxelBox box = bounding_box(mask.size, mask.spacing_mm, mask.voxels, 2.0);
  QCOMPARE(box.low, Eigen::Vector3i(3, 4, 4));
  QCOMPARE(box.high, Eigen::Vector3i(10, 8, 7));
  const Mask part = crop(mask.size, mask.spacing_mm, mask.voxels, box);
  QCOMPARE(part.count(), 2L);
  std::vector<std::uint8_t> back(mask.voxels.size(), 0);
  paste(part, box, mask.size, back);
  QCOMPARE(back, mask.voxels);
  QVERIFY(bounding_box(mask.size, mask.spacing_mm, std::vector<std::uint8_t>(mask.voxels.size(), 0), 5.0)
              .empty());
}

void MorphologyTest::CropOutsideIsRefused() {
  const Mask mask({4, 4, 4}, {1, 1, 1});
  QVERIFY_THROWS_EXCEPTION(PreconditionError,
                           crop(mask.size, mask.spacing_mm, mask.voxels, {{0, 0, 0}, {5, 4, 4}}));
}

QTEST_APPLESS_MAIN(MorphologyTest)
#include "morphology_test.moc"
