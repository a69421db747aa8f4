// SPDX-License-Identifier: GPL-3.0-or-later
// The best region against all regions there are, and on phantoms whose answer is known.
#include "region_cut.h"

#include <QtTest>
#include <random>

#include "enclosed.h"
#include "phantom_field.h"

using namespace glisson;
using namespace glisson::segmentation;
using namespace glisson::test;

namespace {

/// As the header has it.
double worth(const Field& ct, const std::vector<float>& reward, std::size_t region) {
  const auto in = [&](std::size_t voxel) { return (region >> voxel) & 1U; };
  double sum = 0.0;
  for (int k = 0; k < ct.size.z(); ++k)
    for (int j = 0; j < ct.size.y(); ++j)
      for (int i = 0; i < ct.size.x(); ++i) {
        const Eigen::Vector3i v(i, j, k);
        const std::size_t at = ct.offset(v);
        if (in(at)) sum += ct.spacing_mm.x() * reward[at];
        for (int axis = 0; axis < 3; ++axis) {
          const Eigen::Vector3i next = v + Eigen::Vector3i::Unit(axis);
          if (!ct.contains(next) || in(at) == in(ct.offset(next))) continue;
          const double d = (ct.values[at] - ct.values[ct.offset(next)]) / 20.0;
          sum -= 0.1 + 0.9 / (1.0 + d * d);
        }
      }
  return sum;
}

Mask where(const Field& field, float low, float high) {
  Mask mask = field.empty_mask();
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    mask.voxels[i] = field.values[i] > low && field.values[i] < high ? 1 : 0;
  return mask;
}

}  // namespace

class RegionCutTest : public QObject {
  Q_OBJECT
 private slots:
  void NoRegionIsWorthMore();
  void ABiteOfATumourIsFilledAndAnOrganThatLeansIsNot();
  void ANotLiverClickKeepsTheTumourOut();
  void WhatWasPartedFromTheLiverStaysOut();
  void CancelledWorkGivesNothing();
};

void RegionCutTest::NoRegionIsWorthMore() {
  Field ct = field_of({3, 2, 2}, 2.0);
  Mask open = ct.empty_mask();
  for (auto& voxel : open.voxels) voxel = 1;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> hounsfield(0.0F, 80.0F), reward_of(-0.8F, 0.8F);
    std::vector<float> reward(ct.values.size());
    for (float& value : ct.values) value = hounsfield(random);
    for (float& value : reward) value = reward_of(random);
    const Mask region = best_region(ct, open, reward, RunContext()).value();
    std::size_t found = 0;
    for (std::size_t i = 0; i < region.voxels.size(); ++i)
      found |= static_cast<std::size_t>(region.voxels[i]) << i;
    double best = 0.0;
    for (std::size_t other = 0; other < (std::size_t{1} << ct.values.size()); ++other)
      best = std::max(best, worth(ct, reward, other));
    QVERIFY(worth(ct, reward, found) > best - 1e-4);
  }
}

/// A block of liver in fat, with a bite of a tumour in its upper face, and an organ that leans on its side
/// with a small part of its own border.
static Field bitten() {
  Field ct = field_of({60, 50, 50}, 2.0);
  fill(ct, [](const Eigen::Vector3d& p) {
    if ((p - Eigen::Vector3d(45, 70, 45)).norm() < 18.0) return 60.0;
    if ((p - Eigen::Vector3d(101, 40, 45)).norm() < 16.0) return 60.0;
    const bool liver = p.x() > 8 && p.x() < 87 && p.y() > 8 && p.y() < 74 && p.z() > 8 && p.z() < 84;
    return liver ? 108.0 : -95.0;
  });
  smooth(ct, 1.5);
  return ct;
}

void RegionCutTest::ABiteOfATumourIsFilledAndAnOrganThatLeansIsNot() {
  const Field ct = bitten();
  const Mask found = where(ct, 90.0F, 130.0F), nothing = ct.empty_mask();
  const Mask whole =
      with_enclosed(ct, found, found, found, nothing, nothing, nothing, {{{20, 20, 20}}, {}}, RunContext())
          .value();
  QCOMPARE(int(whole.voxels[ct.offset(22, 35, 22)]), 1);
  QCOMPARE(int(whole.voxels[ct.offset(22, 41, 22)]), 1);
  QCOMPARE(int(whole.voxels[ct.offset(50, 20, 22)]), 0);
}

void RegionCutTest::ANotLiverClickKeepsTheTumourOut() {
  const Field ct = bitten();
  const Mask found = where(ct, 90.0F, 130.0F);
  Mask barred = ct.empty_mask();
  for (int k = 20; k < 25; ++k)
    for (int j = 33; j < 38; ++j)
      for (int i = 20; i < 25; ++i) barred.voxels[ct.offset(i, j, k)] = 1;
  const Mask whole = with_enclosed(ct, found, found, found, barred, ct.empty_mask(), ct.empty_mask(),
                                   {{{20, 20, 20}}, {{22, 35, 22}}}, RunContext())
                         .value();
  QCOMPARE(int(whole.voxels[ct.offset(22, 35, 22)]), 0);
}

void RegionCutTest::WhatWasPartedFromTheLiverStaysOut() {
  // A neighbour as bright as the liver lies in the bite, behind a seam.
  Field ct = bitten();
  const Mask found = where(ct, 90.0F, 130.0F), nothing = ct.empty_mask();
  Mask like = found;
  for (int k = 0; k < ct.size.z(); ++k)
    for (int j = 0; j < ct.size.y(); ++j)
      for (int i = 0; i < ct.size.x(); ++i)
        if ((Eigen::Vector3d(i, j, k) * 2.0 - Eigen::Vector3d(45, 70, 45)).norm() < 15.0)
          ct.values[ct.offset(i, j, k)] = 108.0F, like.voxels[ct.offset(i, j, k)] = 1;
  const auto in_bite = [&](const Mask& own) {
    const LiverSeeds seeds{{{20, 20, 20}}, {}};
    const Mask whole =
        with_enclosed(ct, found, like, own, nothing, nothing, nothing, seeds, RunContext()).value();
    return int(whole.voxels[ct.offset(22, 35, 22)]);
  };
  QCOMPARE(in_bite(like), 1);
  QCOMPARE(in_bite(found), 0);
}

void RegionCutTest::CancelledWorkGivesNothing() {
  const auto cancel = std::make_shared<CancelFlag>();
  cancel->request();
  const RunContext context({}, cancel, 1);
  const Field ct = bitten();
  const Mask found = where(ct, 90.0F, 130.0F), nothing = ct.empty_mask();
  QVERIFY(!with_enclosed(ct, found, found, found, nothing, nothing, nothing, {{{20, 20, 20}}, {}}, context));
}

QTEST_APPLESS_MAIN(RegionCutTest)
#include "region_cut_test.moc"
