// SPDX-License-Identifier: GPL-3.0-or-later
// Where a tumour at the rim may lie, on bodies whose hollows are known.
#include "bites.h"

#include <QTest>

using namespace glisson;
using namespace glisson::segmentation;

namespace {

constexpr double kVoxel = 2.0;      // mm
constexpr double kRadius = 70.0;    // mm, of the body
constexpr double kDistance = 70.0;  // mm, of the bite's middle from the body's

/// A ball with a bite of another ball at its side.
/// @param room_mm between it and the volume's edge. @param bite_mm radius of the bite; 0: none.
struct Bitten {
  Mask mask;
  Eigen::Vector3d middle;

  Bitten(double room_mm, double bite_mm) {
    const int half = static_cast<int>((kRadius + room_mm) / kVoxel);
    mask = Mask(Eigen::Vector3i::Constant(2 * half + 1), Eigen::Vector3d::Constant(kVoxel));
    middle = Eigen::Vector3d::Constant(kVoxel * half);
    for (int k = 0; k < mask.size.z(); ++k)
      for (int j = 0; j < mask.size.y(); ++j)
        for (int i = 0; i < mask.size.x(); ++i) {
          const Eigen::Vector3d p = kVoxel * Eigen::Vector3d(i, j, k);
          const double from_bite = (p - middle - kDistance * Eigen::Vector3d::UnitX()).norm();
          mask.voxels[mask.offset(i, j, k)] = (p - middle).norm() < kRadius && from_bite >= bite_mm;
        }
  }

  /// Of the place so far from the middle, in the bite's direction.
  static bool has(const Mask& of, const Eigen::Vector3d& middle, double x_mm) {
    const Eigen::Vector3i v =
        ((middle + x_mm * Eigen::Vector3d::UnitX()) / kVoxel).array().round().cast<int>();
    return of.voxels[of.offset(v.x(), v.y(), v.z())] != 0;
  }
};

}  // namespace

class BitesTest : public QObject {
  Q_OBJECT
 private slots:
  void ABodyWithoutHollowsStaysAsItIsWhereverTheVolumeEnds();
  void ADeepBiteIsFilledAndMayBulge();
  void AShallowDentIsFilledAndDoesNotBulge();
};

void BitesTest::ABodyWithoutHollowsStaysAsItIsWhereverTheVolumeEnds() {
  for (const double room : {2.0, 10.0, 60.0}) {
    const Bitten body(room, 0.0);
    const auto own = static_cast<double>(body.mask.count()),
               hull = static_cast<double>(with_bites(body.mask).count());
    QVERIFY2(hull >= own && hull < 1.02 * own,
             qPrintable(QString("%1 mm: %2 of %3").arg(room).arg(hull).arg(own)));
  }
}

void BitesTest::ADeepBiteIsFilledAndMayBulge() {
  const Bitten body(40.0, 22.0);
  const Mask hull = with_bites(body.mask);
  QVERIFY(!Bitten::has(body.mask, body.middle, 54.0));
  QVERIFY(Bitten::has(hull, body.middle, 54.0));
  QVERIFY(Bitten::has(hull, body.middle, kRadius + 10.0));
  QVERIFY(!Bitten::has(hull, body.middle, kRadius + 30.0));
  QVERIFY(!Bitten::has(hull, body.middle, -kRadius - 6.0));  // on the other side it is as it was
}

void BitesTest::AShallowDentIsFilledAndDoesNotBulge() {
  const Bitten body(40.0, 8.0);
  const Mask hull = with_bites(body.mask);
  QVERIFY(!Bitten::has(body.mask, body.middle, 66.0));
  QVERIFY(Bitten::has(hull, body.middle, 64.0));
  QVERIFY(!Bitten::has(hull, body.middle, kRadius + 6.0));
}

QTEST_APPLESS_MAIN(BitesTest)
#include "bites_test.moc"
