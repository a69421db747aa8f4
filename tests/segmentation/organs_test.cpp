// SPDX-License-Identifier: GPL-3.0-or-later
// The vena cava followed through phantoms whose cross-sections are known.
#include <QTest>
#include <numbers>
#include <random>

#include "organs.h"

using namespace glisson;
using namespace glisson::segmentation;

namespace {

constexpr double kBlood = 150.0, kLiver = 108.0, kFat = -90.0;  // HU
constexpr double kRadius = 12.0, kVein = 2.5;                   // mm
const Eigen::Vector2d kMiddle(49.0, 40.6);                      // mm; x between voxels

enum class Beside { nothing, vessel, vein };

/// A vena cava along z that lies with its left half in liver and with its right half in fat. Beside it, 4 mm
/// of fat between, another vessel as bright; or a vein of the liver that opens into it.
Field phantom(Beside beside) {
  Field ct;
  ct.size = {48, 40, 15};
  ct.spacing_mm = {2.0, 2.0, 2.0};
  ct.values.resize(static_cast<std::size_t>(ct.size.prod()));
  for (int k = 0; k < ct.size.z(); ++k)
    for (int j = 0; j < ct.size.y(); ++j)
      for (int i = 0; i < ct.size.x(); ++i) {
        // Four parts of a voxel to each side: partial volume.
        double sum = 0.0;
        for (int part = 0; part < 16; ++part) {
          const Eigen::Vector2d p(2.0 * i - 0.75 + 0.5 * (part % 4), 2.0 * j - 0.75 + 0.5 * (part / 4));
          const Eigen::Vector2d from = p - kMiddle;
          const bool bright =
              from.norm() < kRadius ||
              (beside == Beside::vessel && (from - Eigen::Vector2d(28.0, 0.0)).norm() < kRadius) ||
              (beside == Beside::vein && from.x() < 0.0 &&
               std::hypot(from.y(), 2.0 * (k - ct.size.z() / 2)) < kVein);
          sum += bright ? kBlood : from.x() < 0.0 ? kLiver : kFat;
        }
        ct.values[ct.offset(i, j, k)] = static_cast<float>(sum / 16.0);
      }
  smooth(ct, 1.5);  // a CT's blur
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0.0F, 2.0F);
  for (float& value : ct.values) value += noise(random);
  return ct;
}

Mask followed(const Field& ct) {
  const Eigen::Vector3d middle(kMiddle.x(), kMiddle.y(), 0.5 * ct.spacing_mm.z() * ct.size.z());
  return follow_cava(ct, {middle.cwiseQuotient(ct.spacing_mm).cast<int>()}, 2);
}

/// mm2 a slice, of the voxels that `counts` says yes to; it is given the place from the cava's middle, mm.
template <class Counts>
double area(const Mask& mask, Counts counts) {
  double voxels = 0.0;
  for (int k = 0; k < mask.size.z(); ++k)
    for (int j = 0; j < mask.size.y(); ++j)
      for (int i = 0; i < mask.size.x(); ++i)
        voxels += mask.voxels[mask.offset(i, j, k)] != 0 &&
                  counts(Eigen::Vector2d(Eigen::Vector2d(2.0 * i, 2.0 * j) - kMiddle));
  return 4.0 * voxels / mask.size.z();
}

}  // namespace

class OrgansTest : public QObject {
  Q_OBJECT
 private slots:
  void CavaReachesToWhereItsBloodIsHalfAsBright();
  void CavaKeepsOutOfAVesselBesideIt();
  void CavaLeavesAVeinThatOpensIntoItToTheVeins();
};

void OrgansTest::CavaReachesToWhereItsBloodIsHalfAsBright() {
  const Mask cava = followed(phantom(Beside::nothing));
  const double half = 0.5 * std::numbers::pi * kRadius * kRadius;
  const double in_liver = area(cava, [](const Eigen::Vector2d& p) { return p.x() < 0.0; });
  const double in_fat = area(cava, [](const Eigen::Vector2d& p) { return p.x() >= 0.0; });
  qInfo("mm2: beside liver %.0f, beside fat %.0f of %.0f", in_liver, in_fat, half);
  QVERIFY(std::abs(in_liver / half - 1.0) < 0.1);
  QVERIFY(std::abs(in_fat / half - 1.0) < 0.1);
}

void OrgansTest::CavaKeepsOutOfAVesselBesideIt() {
  const Mask cava = followed(phantom(Beside::vessel));
  const double whole = std::numbers::pi * kRadius * kRadius;
  QVERIFY(std::abs(area(cava, [](const Eigen::Vector2d&) { return true; }) / whole - 1.0) < 0.1);
  QCOMPARE(area(cava, [](const Eigen::Vector2d& p) { return p.x() > 16.0; }), 0.0);
}

void OrgansTest::CavaLeavesAVeinThatOpensIntoItToTheVeins() {
  const Mask cava = followed(phantom(Beside::vein));
  const auto in_vein = [](const Eigen::Vector2d& p) { return p.x() < 0.0 && p.norm() > kRadius + 3.0; };
  QVERIFY(area(cava, in_vein) < 4.0);  // a voxel of a slice
  QVERIFY(area(cava, [](const Eigen::Vector2d& p) { return p.norm() < kRadius; }) >
          0.9 * std::numbers::pi * kRadius * kRadius);
}

QTEST_APPLESS_MAIN(OrgansTest)
#include "organs_test.moc"
