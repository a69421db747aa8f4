// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps growth from beginning is told beforehand, by the rule that growth itself keeps to.
#include <QTest>

#include "glisson/core/error.h"
#include "glisson/segmentation/segment.h"

using namespace glisson;
using namespace glisson::segmentation;

class HindranceTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void ARegionHoldsEightVoxelsASide();
  void TheLiverHasASeedWhereItIsLookedFor();
  void ALiverThatIsNotFoundIsKept();
  void GrowthKeepsToTheRule();

 private:
  std::optional<Hindrance> found(bool keeps_labels = false) const {
    return hindrance(options_, grid_, seeds_, keeps_labels);
  }
  /// From voxel to voxel, both whole, along each axis.
  void set_region(double low, double high) {
    options_.region = Eigen::AlignedBox3d(grid_.p_in_ct({low, low, low}).xyz);
    options_.region->extend(grid_.p_in_ct({high, high, high}).xyz);
  }
  void put_seed(double place) { seeds_.liver = Points(grid_.p_in_ct({place, place, place}).xyz.transpose()); }

  VolumeGrid grid_;
  Seeds seeds_;
  SegmentationOptions options_;
};

void HindranceTest::init() {
  grid_.size = {40, 40, 40};
  grid_.spacing_mm = {2.0, 2.0, 3.0};
  grid_.origin_mm = {-30.0, 10.0, 50.0};
  seeds_ = {};
  options_ = {};
  put_seed(20.0);
}

void HindranceTest::ARegionHoldsEightVoxelsASide() {
  QVERIFY(!found());
  set_region(15.9, 23.1);
  QVERIFY(!found());
  set_region(16.1, 23.1);
  QVERIFY(found() == Hindrance::small_region);
  set_region(-100.0, -80.0);  // beside the image
  QVERIFY(found() == Hindrance::small_region);
}

void HindranceTest::TheLiverHasASeedWhereItIsLookedFor() {
  set_region(2.0, 12.0);
  QVERIFY(found() == Hindrance::no_liver_seed_in_region);
  put_seed(12.0);
  QVERIFY(!found());
  seeds_.liver.resize(0, 3);
  QVERIFY(found() == Hindrance::no_liver_seed);
  options_.region.reset();
  QVERIFY(found(true) == Hindrance::no_liver_seed);
}

/// Where it is not asked for, and where it is locked: then it needs no seed.
void HindranceTest::ALiverThatIsNotFoundIsKept() {
  seeds_.liver.resize(0, 3);
  options_.locked = {structure::kParenchyma};
  QVERIFY(!found(true));
  QVERIFY(found() == Hindrance::no_kept_liver);
  options_.locked.clear();
  options_.structures.liver = false;
  QVERIFY(!found(true));
  QVERIFY(found() == Hindrance::no_kept_liver);
}

void HindranceTest::GrowthKeepsToTheRule() {
  Image image;
  image.grid = grid_;
  image.modality = Modality::ct;
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(
      static_cast<std::size_t>(grid_.voxel_count()), std::int16_t{100});
  const auto refused = [&] {
    try {
      segment(image, seeds_, options_, RunContext());
    } catch (const InputError& error) {
      return error.field();
    }
    return std::string();
  };
  set_region(16.1, 23.1);
  QCOMPARE(refused(), std::string("region"));
  set_region(2.0, 12.0);
  QCOMPARE(refused(), std::string("liver"));
  options_.region.reset();
  options_.structures.liver = false;
  QCOMPARE(refused(), std::string("liver"));
}

QTEST_APPLESS_MAIN(HindranceTest)
#include "hindrance_test.moc"
