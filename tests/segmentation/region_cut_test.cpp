// SPDX-License-Identifier: GPL-3.0-or-later
// The best region against all regions there are, and on phantoms whose answer is known.
#include "region_cut.h"

#include <QTest>
#include <random>

#include "enclosed.h"
#include "phantom_field.h"

using namespace glisson;
using namespace glisson::segmentation;
using namespace glisson::test;

namespace {

constexpr Tissue kLiver{108.0, 8.0};

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

void each_room() {
  QTest::addColumn<double>("room_mm");
  for (const double room : {0.0, 20.0, 60.0}) QTest::addRow("%.0f mm of room", room) << room;
}

}  // namespace

class RegionCutTest : public QObject {
  Q_OBJECT
 private slots:
  void NoRegionIsWorthMore();
  void ABiteOfATumourIsFilledAndAnOrganThatLeansIsNot_data() { each_room(); }
  void ABiteOfATumourIsFilledAndAnOrganThatLeansIsNot();
  void ALargeBiteIsFilledWhereTheLiverEnclosesIt();
  void ATumourThatNoEdgePartsFromAMuscleIsTakenAndTheMuscleIsNot();
  void ACystAtTheRimIsFilledAndAGallbladderInItsBedIsNot();
  void AStomachUnderALargeLobeIsLeft_data();
  void AStomachUnderALargeLobeIsLeft();
  void WhatOnlyTheClicksTookForLiverIsNoOrgan();
  void ANotLiverClickKeepsTheTumourOut();
  void WhatWasPartedFromTheLiverStaysOut_data() { each_room(); }
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

/// A block of liver in fat, with a bite of a tumour in its upper face that bulges by 14 mm, and an organ that
/// leans on its side with a small part of its own border.
struct Bitten {
  Field ct;
  Eigen::Vector3i room;

  /// @param room_mm between the block's surroundings and the volume's edge: it must not matter.
  explicit Bitten(double room_mm, double tumour_mm = 18.0)
      : room(Eigen::Vector3i::Constant(static_cast<int>(room_mm / kVoxel))) {
    ct = field_of(Eigen::Vector3i(60, 50, 50) + 2 * room, kVoxel);
    fill(ct, [&](const Eigen::Vector3d& at) {
      const Eigen::Vector3d p = at - kVoxel * room.cast<double>();
      if ((p - kTumour).norm() < tumour_mm) return 60.0;
      if ((p - Eigen::Vector3d(101, 40, 45)).norm() < 16.0) return 60.0;
      const bool liver = p.x() > 8 && p.x() < 87 && p.y() > 8 && p.y() < 74 && p.z() > 8 && p.z() < 84;
      return liver ? 108.0 : -95.0;
    });
    smooth(ct, 1.5);
  }
  Eigen::Vector3i voxel(int i, int j, int k) const { return Eigen::Vector3i(i, j, k) + room; }
  std::size_t at(int i, int j, int k) const { return ct.offset(voxel(i, j, k)); }
  Mask found() const { return where(ct, 90.0F, 130.0F); }
  /// Puts in a ball, millimetres. @return whether its middle is taken for a part of the liver.
  bool takes_ball(const Eigen::Vector3d& middle, double radius_mm, float hounsfield) {
    for (std::size_t i = 0; i < ct.values.size(); ++i)
      if ((kVoxel * (ct.voxel_at(i) - room).cast<double>() - middle).norm() < radius_mm)
        ct.values[i] = hounsfield;
    const Mask liver = found(), nothing = ct.empty_mask();
    const Mask whole = with_enclosed(ct, liver, kLiver, liver, liver, nothing, nothing, nothing,
                                     {{voxel(10, 8, 10)}, {}}, RunContext())
                           .value();
    const Eigen::Vector3i at_middle = (middle / kVoxel).cast<int>();
    return whole.voxels[at(at_middle.x(), at_middle.y(), at_middle.z())] != 0;
  }

  static constexpr double kVoxel = 2.0;
  static inline const Eigen::Vector3d kTumour{45, 70, 45};
};

void RegionCutTest::ABiteOfATumourIsFilledAndAnOrganThatLeansIsNot() {
  QFETCH(double, room_mm);
  const Bitten bitten(room_mm);
  const Mask found = bitten.found(), nothing = bitten.ct.empty_mask();
  const Mask whole = with_enclosed(bitten.ct, found, kLiver, found, found, nothing, nothing, nothing,
                                   {{bitten.voxel(20, 20, 20)}, {}}, RunContext())
                         .value();
  QCOMPARE(int(whole.voxels[bitten.at(22, 35, 22)]), 1);
  QCOMPARE(int(whole.voxels[bitten.at(22, 41, 22)]), 1);
  QCOMPARE(int(whole.voxels[bitten.at(50, 20, 22)]), 0);
}

void RegionCutTest::ALargeBiteIsFilledWhereTheLiverEnclosesIt() {
  QVERIFY(Bitten(40.0, 0.0).takes_ball({47, 50, 46}, 32.0, 60.0F));
  // It leans on the liver with a third of its border.
  QVERIFY(!Bitten(40.0, 0.0).takes_ball({47, 88, 46}, 32.0, 60.0F));
}

void RegionCutTest::ATumourThatNoEdgePartsFromAMuscleIsTakenAndTheMuscleIsNot() {
  // Half of it lies in the liver; a plate as dark as it is covers the liver's face, as the diaphragm the
  // dome.
  Bitten bitten(40.0, 0.0);
  Field& ct = bitten.ct;
  for (std::size_t i = 0; i < ct.values.size(); ++i) {
    const Eigen::Vector3d p = Bitten::kVoxel * (ct.voxel_at(i) - bitten.room).cast<double>();
    const bool is_plate = p.y() > 74.0 && p.y() < 90.0;
    if (is_plate || (p - Eigen::Vector3d(46, 74, 46)).norm() < 30.0) ct.values[i] = 30.0F;
  }
  const Mask found = bitten.found(), nothing = ct.empty_mask();
  const auto whole = [&](const std::vector<Eigen::Vector3i>& not_liver) {
    Mask barred = nothing;  // what lies around a click is its side's
    for (const Eigen::Vector3i& p : not_liver) barred.voxels[ct.offset(p)] = 1;
    return with_enclosed(ct, found, kLiver, found, found, dilated(barred, 4.0), nothing, nothing,
                         {{bitten.voxel(10, 8, 10)}, not_liver}, RunContext())
        .value();
  };
  const Mask taken = whole({});
  for (const int y : {25, 35}) QCOMPARE(int(taken.voxels[bitten.at(23, y, 23)]), 1);
  QCOMPARE(int(taken.voxels[bitten.at(23, 43, 23)]), 0);
  QCOMPARE(int(taken.voxels[bitten.at(8, 41, 8)]), 0);
  QCOMPARE(int(whole({bitten.voxel(23, 30, 23)}).voxels[bitten.at(23, 25, 23)]), 0);
}

void RegionCutTest::ACystAtTheRimIsFilledAndAGallbladderInItsBedIsNot() {
  // The liver's face is at 74 mm: a sixth of the cyst's surface is free, of the gallbladder's 60 %.
  QVERIFY(Bitten(20.0, 0.0).takes_ball({46, 60, 46}, 20.0, 8.0F));
  QVERIFY(!Bitten(20.0, 0.0).takes_ball({46, 78, 46}, 20.0, 8.0F));
}

void RegionCutTest::AStomachUnderALargeLobeIsLeft_data() {
  QTest::addColumn<double>("middle_mm");
  QTest::addColumn<double>("hounsfield");
  for (const double middle : {105.0, 115.0})
    for (const double hounsfield : {40.0, 60.0})
      QTest::addRow("%.0f mm, %.0f HU", middle, hounsfield) << middle << hounsfield;
}

void RegionCutTest::AStomachUnderALargeLobeIsLeft() {
  QFETCH(double, middle_mm);
  QFETCH(double, hounsfield);
  // The lobe's face is at 100 mm and hollowed out by the stomach, by up to 35 mm; no seam parts them.
  Field ct = field_of({110, 80, 80}, 2.0);
  const auto in_stomach = [&](const Eigen::Vector3d& p) {
    return (p - Eigen::Vector3d(110, middle_mm, 80)).cwiseQuotient(Eigen::Vector3d(45, 40, 60)).norm() < 1.0;
  };
  fill(ct, [&](const Eigen::Vector3d& p) {
    const bool liver = p.x() > 30 && p.x() < 190 && p.y() > 20 && p.y() < 100 && p.z() > 30 && p.z() < 130;
    return in_stomach(p) ? hounsfield : liver ? 108.0 : -95.0;
  });
  smooth(ct, 1.5);
  const Mask found = largest_component(where(ct, 90.0F, 130.0F)), nothing = ct.empty_mask();
  const Mask whole = with_enclosed(ct, found, kLiver, found, found, nothing, nothing, nothing,
                                   {{{20, 15, 20}}, {}}, RunContext())
                         .value();
  long taken = 0, all = 0;
  each_voxel(ct, [&](std::size_t at, const Eigen::Vector3d& p) {
    if (!in_stomach(p)) return;
    ++all;
    taken += whole.voxels[at] != 0;
  });
  qInfo("%ld of %ld voxels", taken, all);
  QVERIFY(100 * taken < all);
}

void RegionCutTest::WhatOnlyTheClicksTookForLiverIsNoOrgan() {
  // Clicks that differ, as with one in a cyst, make a window so wide that the tumour looks like liver.
  const Bitten bitten(20.0);
  const Mask found = bitten.found(), nothing = bitten.ct.empty_mask(), like = where(bitten.ct, 40.0F, 130.0F);
  const Mask whole = with_enclosed(bitten.ct, found, kLiver, like, found, nothing, nothing, nothing,
                                   {{bitten.voxel(20, 20, 20)}, {}}, RunContext())
                         .value();
  QCOMPARE(int(whole.voxels[bitten.at(22, 35, 22)]), 1);
  QCOMPARE(int(whole.voxels[bitten.at(50, 20, 22)]), 0);
}

void RegionCutTest::ANotLiverClickKeepsTheTumourOut() {
  const Bitten bitten(20.0);
  const Mask found = bitten.found(), nothing = bitten.ct.empty_mask();
  Mask barred = nothing;
  for (int k = 20; k < 25; ++k)
    for (int j = 33; j < 38; ++j)
      for (int i = 20; i < 25; ++i) barred.voxels[bitten.at(i, j, k)] = 1;
  const Mask whole = with_enclosed(bitten.ct, found, kLiver, found, found, barred, nothing, nothing,
                                   {{bitten.voxel(20, 20, 20)}, {bitten.voxel(22, 35, 22)}}, RunContext())
                         .value();
  QCOMPARE(int(whole.voxels[bitten.at(22, 35, 22)]), 0);
}

void RegionCutTest::WhatWasPartedFromTheLiverStaysOut() {
  QFETCH(double, room_mm);
  // A neighbour as bright as the liver lies in the bite, behind a seam.
  Bitten bitten(room_mm);
  Field& ct = bitten.ct;
  const Mask found = bitten.found(), nothing = ct.empty_mask();
  Mask like = found;
  for (int k = 0; k < 50; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 60; ++i)
        if ((Eigen::Vector3d(i, j, k) * Bitten::kVoxel - Bitten::kTumour).norm() < 15.0)
          ct.values[bitten.at(i, j, k)] = 108.0F, like.voxels[bitten.at(i, j, k)] = 1;
  const auto in_bite = [&](const Mask& own) {
    const LiverSeeds seeds{{bitten.voxel(20, 20, 20)}, {}};
    const Mask whole =
        with_enclosed(ct, found, kLiver, like, own, nothing, nothing, nothing, seeds, RunContext()).value();
    return int(whole.voxels[bitten.at(22, 35, 22)]);
  };
  QCOMPARE(in_bite(like), 1);
  QCOMPARE(in_bite(found), 0);
}

void RegionCutTest::CancelledWorkGivesNothing() {
  const auto cancel = std::make_shared<CancelFlag>();
  cancel->request();
  const RunContext context({}, cancel, 1);
  const Bitten bitten(0.0);
  const Field& ct = bitten.ct;
  const Mask found = bitten.found(), nothing = ct.empty_mask();
  QVERIFY(!with_enclosed(ct, found, kLiver, found, found, nothing, nothing, nothing, {{{20, 20, 20}}, {}},
                         context));
}

QTEST_APPLESS_MAIN(RegionCutTest)
#include "region_cut_test.moc"
