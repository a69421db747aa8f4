// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that hang together by a neck, or across a seam, on phantoms whose parts are known.
#include "parting.h"

#include <QTest>
#include <random>

#include "fronts.h"
#include "liver_start.h"
#include "phantom_field.h"

using namespace glisson;
using namespace glisson::segmentation;
using namespace glisson::test;

namespace {

const Eigen::Vector3d kLarge(40, 36, 36);  // mm
constexpr double kLargeRadius = 30.0;

/// A large ball and, beside it, a small one; a rod joins the middles.
Mask two_balls(const Field& field, double small_x, double small_radius, double rod_radius) {
  return body(field, [=](const Eigen::Vector3d& p) {
    const Eigen::Vector3d small(small_x, kLarge.y(), kLarge.z());
    const bool rod = p.x() > kLarge.x() && p.x() < small_x && (p - kLarge).tail<2>().norm() < rod_radius;
    return rod || (p - kLarge).norm() < kLargeRadius || (p - small).norm() < small_radius;
  });
}

Eigen::Vector3i at_mm(double x) { return Eigen::Vector3d(x / 1.5, 24, 24).cast<int>(); }

std::uint8_t side_at(const Field& field, const Mask& mask, double x) {
  return mask.voxels[field.offset(at_mm(x))];
}

Sides parted(const Field& field, const Mask& tissue, const LiverSeeds& seeds) {
  return part_at_necks(field, tissue, seeds, RunContext()).value();
}

}  // namespace

class PartingTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatHangsByANeckIsARival();
  void WhatIsBroadlyJoinedIsOwned();
  void WhatMeetsInStripsIsARival();
  void ALobeBehindATumourIsDoubtful();
  void ALobeInPiecesIsDoubtfulAsOne();
  void ATumourThatNobodyClickedIsNoNeck();
  void AClickInsideTakesWhatHangsByANeck();
  void ClicksOnBothSidesPartAtTheNarrowestPlace();
  void FrontsMeetInTheNeck();
  void ASeamIsFoundAndNoiseIsNone();

 private:
  Field field_ = field_of({90, 48, 48}, 1.5);
};

void PartingTest::WhatHangsByANeckIsARival() {
  const Mask tissue = two_balls(field_, 92.0, 18.0, 5.0);
  const Sides sides = parted(field_, tissue, {{at_mm(30)}, {}});
  QCOMPARE(side_at(field_, sides.own, 40), 1);
  QCOMPARE(side_at(field_, sides.own, 95), 0);
  QCOMPARE(side_at(field_, sides.rival, 95), 1);
  QCOMPARE(side_at(field_, sides.rival, 40), 0);
}

void PartingTest::WhatIsBroadlyJoinedIsOwned() {
  // A lobe: the waist is as wide as the lobe is thick.
  const Mask tissue = two_balls(field_, 80.0, 20.0, 18.0);
  const Sides sides = parted(field_, tissue, {{at_mm(30)}, {}});
  QCOMPARE(side_at(field_, sides.own, 85), 1);
  QCOMPARE(sides.rival.count(), 0L);
}

void PartingTest::WhatMeetsInStripsIsARival() {
  // A layer of 15 mm behind a seam with slits: they are two thirds of it, and 3 mm wide.
  const auto behind = [&](bool slits) {
    const Mask tissue = body(field_, [&](const Eigen::Vector3d& p) {
      const bool large = p.x() > 6.0 && p.x()<60.0, layer = p.x()> 60.7 && p.x() < 76.0;
      const bool open = slits && static_cast<int>(std::lround(p.y() / 1.5)) % 3 != 0;
      const bool seam = !large && !layer && p.x() > 6.0 && p.x() < 76.0;
      const bool in_height = (p.tail<2>() - kLarge.tail<2>()).cwiseAbs().maxCoeff() < 28.0;
      return in_height && (large || layer || (seam && (open || !slits)));
    });
    return parted(field_, tissue, {{at_mm(30)}, {}});
  };
  const Sides open = behind(false), slits = behind(true);
  QCOMPARE(side_at(field_, open.own, 69), 1);
  QCOMPARE(side_at(field_, slits.own, 69), 0);
  QCOMPARE(side_at(field_, slits.rival, 69), 1);
}

void PartingTest::ALobeBehindATumourIsDoubtful() {
  const Sides sides = parted(field_, two_balls(field_, 100.0, 30.0, 18.0), {{at_mm(30)}, {}});
  QCOMPARE(side_at(field_, sides.own, 100), 0);
  QVERIFY(sides.doubtful_ml > 100.0 && sides.doubtful_ml < 125.0);
  QVERIFY((1.5 * sides.doubtful.cast<double>() - Eigen::Vector3d(100, 36, 36)).norm() < 3.0);
  // By a thin rod hangs another organ, and what is small is no lobe.
  QCOMPARE(parted(field_, two_balls(field_, 100.0, 30.0, 7.0), {{at_mm(30)}, {}}).doubtful_ml, 0.0);
  QCOMPARE(parted(field_, two_balls(field_, 92.0, 18.0, 10.0), {{at_mm(30)}, {}}).doubtful_ml, 0.0);
  // Nor is there a doubt where somebody has said what it is.
  QCOMPARE(parted(field_, two_balls(field_, 100.0, 30.0, 18.0), {{at_mm(30)}, {at_mm(100)}}).doubtful_ml,
           0.0);
}

void PartingTest::ALobeInPiecesIsDoubtfulAsOne() {
  // Two balls of 74 ml behind each other, neither as large as a lobe that would be told. What joins them is
  // as broad as they are, and flatter.
  const Field field = field_of({130, 48, 48}, 1.5);
  const auto joined_by = [&](double width, double thickness) {
    const Mask tissue = body(field, [=](const Eigen::Vector3d& p) {
      const Eigen::Vector3d d = p - kLarge;
      const bool rod = d.x() > 0.0 && d.x() < 60.0 && d.tail<2>().norm() < 19.5;
      const bool slab =
          d.x() > 60.0 && d.x() < 104.0 && std::abs(d.y()) < 0.5 * width && std::abs(d.z()) < 0.5 * thickness;
      return rod || slab || d.norm() < kLargeRadius || (d - Eigen::Vector3d(60, 0, 0)).norm() < 26.0 ||
             (d - Eigen::Vector3d(104, 0, 0)).norm() < 26.0;
    });
    return parted(field, tissue, {{at_mm(30)}, {}});
  };
  const Sides sides = joined_by(52.0, 38.0);
  QCOMPARE(side_at(field, sides.own, 95) + side_at(field, sides.own, 144), 0);
  QVERIFY2(sides.doubtful_ml > 150.0 && sides.doubtful_ml < 200.0,
           qPrintable(QString::number(sides.doubtful_ml)));
  // So it is where the pieces hang together no better than the first one does on the liver.
  const Sides chain = joined_by(24.0, 22.0);
  QVERIFY2(chain.doubtful_ml > 130.0 && chain.doubtful_ml < 150.0,
           qPrintable(QString::number(chain.doubtful_ml)));
  QCOMPARE(side_at(field, chain.perhaps, 95) + side_at(field, chain.perhaps, 144), 1);  // a piece of it
  // What hangs on the piece by a thin rod is not of its body.
  QCOMPARE(joined_by(12.0, 12.0).doubtful_ml, 0.0);
}

void PartingTest::ATumourThatNobodyClickedIsNoNeck() {
  // Two lobes of 113 ml and a waist as broad as they are. What is bitten out of the waist leaves less of it
  // than joins a lobe. `hounsfield` of the bite; `aside` mm that its middle lies beside the waist's.
  const auto lobe_is_owned = [&](double hounsfield, double waist, double aside) {
    Field ct = field_;
    std::mt19937 random(2);
    std::normal_distribution<float> noise(0.0F, 3.0F);
    const Mask liver = two_balls(ct, 100.0, 33.0, waist);
    each_voxel(ct, [&](std::size_t at, const Eigen::Vector3d& p) {
      const bool bite = (p - kLarge - Eigen::Vector3d(30, 0, aside)).norm() < 22.0;
      ct.values[at] = static_cast<float>(bite ? hounsfield : liver.voxels[at] != 0 ? 108.0 : -95.0);
    });
    smooth(ct, 1.0);
    for (float& value : ct.values) value += noise(random);
    const Mask none = ct.empty_mask();
    const auto start = find_start(ct, {ct, ct}, {{at_mm(30), at_mm(45)}, {}}, none, none, none, RunContext());
    return side_at(ct, start->own, 108);
  };
  QCOMPARE(lobe_is_owned(108.0, 28.0, 6.0), 1);
  QCOMPARE(lobe_is_owned(60.0, 28.0, 6.0), 1);
  // Fat there is a fissure, and what leans on a waist is not enclosed.
  QCOMPARE(lobe_is_owned(-95.0, 28.0, 6.0), 0);
  QCOMPARE(lobe_is_owned(60.0, 20.0, 40.0), 0);
}

void PartingTest::AClickInsideTakesWhatHangsByANeck() {
  const Mask tissue = two_balls(field_, 92.0, 18.0, 5.0);
  for (const LiverSeeds& seeds :
       {LiverSeeds{{at_mm(30), at_mm(97)}, {}}, LiverSeeds{{at_mm(30)}, {}, {at_mm(97)}}})
    QCOMPARE(side_at(field_, parted(field_, tissue, seeds).own, 92), 1);
}

void PartingTest::ClicksOnBothSidesPartAtTheNarrowestPlace() {
  // So hardly a waist that both would be one without the click.
  const Mask tissue = two_balls(field_, 80.0, 22.0, 19.0);
  const Sides sides = parted(field_, tissue, {{at_mm(30)}, {at_mm(90)}});
  QCOMPARE(side_at(field_, sides.own, 40), 1);
  QCOMPARE(side_at(field_, sides.own, 85), 0);
  QCOMPARE(side_at(field_, sides.rival, 85), 1);
}

void PartingTest::FrontsMeetInTheNeck() {
  // Balls that end at 70 and 74 mm, and a rod between them; one click lies just beside it.
  const Mask tissue = two_balls(field_, 92.0, 18.0, 5.0);
  const std::vector<std::uint8_t> who =
      first_to_reach(tissue, squared_depth_mm2(tissue), {{at_mm(64)}, {at_mm(97)}, {}});
  const auto at = [&](double x) { return int(who[field_.offset(at_mm(x))]); };
  QCOMPARE(at(20), 1);
  QCOMPARE(at(66), 1);
  QCOMPARE(at(78), 2);
  QCOMPARE(at(105), 2);
  for (std::size_t i = 0; i < who.size(); ++i) QCOMPARE(who[i] != 0, tissue.voxels[i] != 0);
}

void PartingTest::ASeamIsFoundAndNoiseIsNone() {
  // Fat of 1.5 mm between two organs, blurred as a CT blurs it.
  constexpr double kSeam = 70.0;
  Field ct = field_;
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0.0F, 12.0F);
  fill(ct, [](const Eigen::Vector3d& p) { return std::abs(p.x() - kSeam) < 0.75 ? -90.0 : 108.0; });
  smooth(ct, 1.2);
  for (float& value : ct.values) value += noise(random);
  const Mask all = body(ct, [](const Eigen::Vector3d&) { return true; });
  const Mask away = body(ct, [&](const Eigen::Vector3d& p) { return p.x() < 40.0; });
  DarkSheets sheets(ct, all);
  sheets.learn(away);
  const Mask seams = sheets.sheets();
  // A click beside the seam would hide it; tissue elsewhere tells better, whichever comes first.
  const Mask beside = body(ct, [](const Eigen::Vector3d& p) { return std::abs(p.x() - kSeam) < 4.0; });
  DarkSheets hidden(ct, all);
  hidden.learn(beside);
  QVERIFY(2 * hidden.sheets().count() < seams.count());
  hidden.learn(away);
  QVERIFY(hidden.sheets().voxels == seams.voxels);
  sheets.learn(beside);
  QVERIFY(sheets.sheets().voxels == seams.voxels);
  long found = 0, of = 0, wrong = 0, others = 0;
  for (int k = 4; k + 4 < ct.size.z(); ++k)
    for (int j = 4; j + 4 < ct.size.y(); ++j)
      for (int i = 4; i + 4 < ct.size.x(); ++i) {
        const double away_mm = std::abs(1.5 * i - kSeam);
        const bool marked = seams.voxels[ct.offset(i, j, k)] != 0;
        if (away_mm < 0.75)
          ++of, found += marked;
        else if (away_mm > 8.0)
          ++others, wrong += marked;
      }
  QVERIFY2(100 * found > 95 * of, qPrintable(QString("%1 of %2").arg(found).arg(of)));
  QVERIFY2(100 * wrong < 8 * others, qPrintable(QString("%1 of %2").arg(wrong).arg(others)));
}

QTEST_APPLESS_MAIN(PartingTest)
#include "parting_test.moc"
