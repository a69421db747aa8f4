// SPDX-License-Identifier: GPL-3.0-or-later
// What clicks do to the labels, on a phantom that is known.
#include <QTest>
#include <cmath>
#include <numbers>

#include "glisson/core/error.h"
#include "glisson/segmentation/kept_notes.h"
#include "glisson/segmentation/segment.h"
#include "noisy_ct.h"
#include "points_at.h"

using namespace glisson;
using namespace glisson::segmentation;

namespace {

struct Phantom {
  Image image;
  std::vector<std::uint8_t> liver, tumour;
};

const Eigen::Vector3d kLesion(46, 68, 53), kTumour(59, 33, 48), kLiver(66, 61, 53);  // mm
constexpr double kLesionRadius = 12.0, kTumourRadius = 19.0;

/// An ellipsoid of 108 HU in fat with a lesion inside, and a dark tumour at its rim that sticks out.
Phantom phantom(const Eigen::Vector3d& tumour_middle = kTumour) {
  Phantom result;
  VolumeGrid grid;
  grid.size = {67, 61, 48};
  grid.spacing_mm = {2.0, 2.0, 2.2};
  grid.origin_mm = {-90, -60, 20};
  result.image = test::noisy_ct(grid, 7, 10.0, [&](const Eigen::Vector3d& p) {
    const bool organ = (p - kLiver).cwiseQuotient(Eigen::Vector3d(50, 42, 38)).norm() < 1.0;
    const bool tumour = (p - tumour_middle).norm() < kTumourRadius;
    const double in_lesion = (p - kLesion).norm() - kLesionRadius;
    double hu = organ ? 108.0 : -95.0;
    if (tumour) hu = 62.0;
    if (in_lesion < 0.0) hu = 64.0;
    result.liver.push_back(organ || tumour || in_lesion < 0.0 ? 1 : 0);
    result.tumour.push_back(tumour ? 1 : 0);
    return hu;
  });
  return result;
}

Seeds clicks_in(const Image& image) {
  Seeds seeds;
  seeds.liver = test::points_at(image, {{83, 67, 48}, {72, 80, 64}, {88, 53, 61}});
  return seeds;
}

Segmented segmented(const Image& image, const Seeds& seeds, const SegmentationOptions& options = {},
                    const LabelMap* kept = nullptr) {
  return segment(image, seeds, options, RunContext(), kept).value();
}

std::vector<std::uint8_t> mask_of(const LabelMap& labels, Label label) {
  return labels.voxels.mask([=](Label l) { return l == label; });
}

Label label_at(const Segmented& result, const Eigen::Vector3d& mm) {
  const VolumeGrid& grid = result.labels.voxels.grid();
  return result.labels.voxels.at(mm.cwiseQuotient(grid.spacing_mm).array().round().matrix().cast<int>());
}

bool has_note(const Segmented& result, const std::string& begin) {
  return std::any_of(result.report.notes.begin(), result.report.notes.end(),
                     [&](const std::string& note) { return note.starts_with(begin); });
}

/// How many voxels farther than `mm` from a place differ.
long changed_beyond(const Segmented& a, const Segmented& b, const Eigen::Vector3d& place, double mm) {
  const VolumeGrid& grid = a.labels.voxels.grid();
  long count = 0;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Eigen::Vector3d p = Eigen::Vector3d(i, j, k).cwiseProduct(grid.spacing_mm);
        if ((p - place).norm() > mm && a.labels.voxels.at({i, j, k}) != b.labels.voxels.at({i, j, k}))
          ++count;
      }
  return count;
}

}  // namespace

class ClicksTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void ATumourAtTheRimIsLiver();
  void ATumourThatStandsOutIsLiver();
  void ALiverClickBinds();
  void ALiverClickInATumourTakesIt();
  void TumoursThatTouchArePartedAtTheNeck();
  void ALobeThatIsLeftOutIsTold();
  void ADarkBodyThatNobodyClickedIsTold();
  void ANotLiverClickBinds();
  void AClickOnAnIslandIsNamed();
  void OnFineVoxelsNoIslandIsMadeEither();
  void InARegionClicksKeepTheirNumbers();
  void WhatIsFoundNowhereLeavesWhatThereWas();
  void AVesselThatIsFoundNowhereStays();
  void ALesionThatIsFoundNowhereStays();
  void OneMoreClickChangesNothingFarAway();
  void ALockedLesionStaysVoxelByVoxel();
  void ALockedLiverStaysVoxelByVoxel();

 private:
  Phantom phantom_;
  Segmented found_;
};

void ClicksTest::initTestCase() {
  phantom_ = phantom();
  found_ = segmented(phantom_.image, clicks_in(phantom_.image));
}

void ClicksTest::ATumourAtTheRimIsLiver() {
  const std::vector<std::uint8_t> liver = inside_liver(found_.labels);
  const double all = dice(liver, phantom_.liver);
  QVERIFY2(all > 0.96, qPrintable(QString::number(all)));
  long in = 0, of = 0;
  for (std::size_t i = 0; i < liver.size(); ++i) {
    of += phantom_.tumour[i] != 0;
    in += phantom_.tumour[i] != 0 && liver[i] != 0;
  }
  QVERIFY2(10 * in > 9 * of, qPrintable(QString("%1 of %2").arg(in).arg(of)));
}

void ClicksTest::ATumourThatStandsOutIsLiver() {
  const Phantom out = phantom({59, 20, 48});  // half of it
  QVERIFY(dice(inside_liver(segmented(out.image, clicks_in(out.image)).labels), out.liver) > 0.93);
}

void ClicksTest::ALiverClickBinds() {
  // Anywhere in what is liver, the tumour's rim and the organ's among it.
  for (const Eigen::Vector3d& place :
       {Eigen::Vector3d(kTumour + Eigen::Vector3d(0, -14, 0)), Eigen::Vector3d(112, 61, 53)}) {
    Seeds seeds = clicks_in(phantom_.image);
    seeds.liver.conservativeResize(4, 3);
    seeds.liver.row(3) = test::points_at(phantom_.image, {place}).row(0);
    const Segmented result = segmented(phantom_.image, seeds);
    QCOMPARE(label_at(result, place), structure::kParenchyma);
    QVERIFY(!has_note(result, "seed."));
  }
}

void ClicksTest::ALiverClickInATumourTakesIt() {
  // Most of it stands out of the organ.
  const Eigen::Vector3d middle(59, 12, 48);
  const Phantom out = phantom(middle);
  const auto share_taken = [&](const Seeds& seeds) {
    const std::vector<std::uint8_t> liver = inside_liver(segmented(out.image, seeds).labels);
    long taken = 0, all = 0;
    for (std::size_t i = 0; i < liver.size(); ++i)
      all += out.tumour[i], taken += out.tumour[i] != 0 && liver[i] != 0;
    return static_cast<double>(taken) / static_cast<double>(all);
  };
  Seeds seeds = clicks_in(out.image);
  const double unclicked = share_taken(seeds);
  seeds.liver.conservativeResize(4, 3);
  seeds.liver.row(3) = test::points_at(out.image, {middle}).row(0);
  const double clicked = share_taken(seeds);
  QVERIFY2(unclicked < 0.5 && clicked > 0.9, qPrintable(QString("%1 %2").arg(unclicked).arg(clicked)));
}

void ClicksTest::TumoursThatTouchArePartedAtTheNeck() {
  // A small one and a large one, overlapping by 3 mm; the clicks are not in their middles.
  const Eigen::Vector3d small(46, 60, 53), large(73, 62, 53);
  constexpr double kSmall = 12.0, kLarge = 18.0;
  VolumeGrid grid = phantom_.image.grid;
  std::vector<std::uint8_t> in_small, in_large;
  const Image image = test::noisy_ct(grid, 9, 10.0, [&](const Eigen::Vector3d& p) {
    const bool organ = (p - kLiver).cwiseQuotient(Eigen::Vector3d(50, 42, 38)).norm() < 1.0;
    const double to_small = (p - small).norm() - kSmall, to_large = (p - large).norm() - kLarge;
    in_small.push_back(to_small < 0.0 && to_small <= to_large);
    in_large.push_back(to_large < 0.0 && to_large < to_small);
    return std::min(to_small, to_large) < 0.0 ? 62.0 : organ ? 108.0 : -95.0;
  });
  Seeds seeds;
  seeds.liver = test::points_at(image, {{66, 30, 48}, {66, 92, 58}, {100, 60, 53}});
  const PointsIn<CtFrame> clicks[] = {test::points_at(image, {{50, 56, 50}}),
                                      test::points_at(image, {{68, 66, 56}})};
  for (const bool exchanged : {false, true}) {
    seeds.lesions = {clicks[exchanged ? 1 : 0], clicks[exchanged ? 0 : 1]};
    const Segmented result = segmented(image, seeds);
    const double first =
                     dice(mask_of(result.labels, structure::kFirstLesion), exchanged ? in_large : in_small),
                 second = dice(mask_of(result.labels, structure::kFirstLesion + 1),
                               exchanged ? in_small : in_large);
    QVERIFY2(first > 0.85 && second > 0.85, qPrintable(QString("%1 %2").arg(first).arg(second)));
  }
}

void ClicksTest::ALobeThatIsLeftOutIsTold() {
  // Two balls of 125 ml with a waist, as a lobe behind a tumour.
  const Eigen::Vector3d first(36, 61, 53), second(99, 61, 53);
  const Image image = test::noisy_ct(phantom_.image.grid, 4, 8.0, [&](const Eigen::Vector3d& p) {
    const bool waist = p.x() > first.x() && p.x() < second.x() && (p - first).tail<2>().norm() < 18.0;
    return waist || (p - first).norm() < 31.0 || (p - second).norm() < 31.0 ? 108.0 : -95.0;
  });
  Seeds seeds;
  seeds.liver = test::points_at(image, {{30, 55, 48}, {42, 70, 58}});
  const Segmented half = segmented(image, seeds);
  QCOMPARE(label_at(half, second), structure::kBackground);
  QVERIFY(has_note(half, "liver.perhaps_more 1"));
  const auto doubt = std::ranges::find_if(
      half.report.notes, [](const std::string& note) { return note.starts_with("liver.perhaps_more"); });
  seeds.liver = test::points_at(image, {{30, 55, 48}, {42, 70, 58}, {98, 55, 48}});
  const Segmented whole = segmented(image, seeds);
  QCOMPARE(label_at(whole, second), structure::kParenchyma);
  QVERIFY(!has_note(whole, "liver.perhaps_more"));
  QVERIFY(!is_settled(*doubt, half.labels) && is_settled(*doubt, whole.labels));
}

void ClicksTest::ADarkBodyThatNobodyClickedIsTold() {
  // Both are in the liver, the larger one first.
  std::vector<std::string> told;
  std::ranges::copy_if(found_.report.notes, std::back_inserter(told),
                       [](const std::string& note) { return note.starts_with("liver.dark_body"); });
  QCOMPARE(told.size(), std::size_t{2});
  for (const auto& [note, radius] : {std::pair{told[0], kTumourRadius}, {told[1], kLesionRadius}}) {
    const double ml = 4.0 / 3.0 * std::numbers::pi * std::pow(0.1 * radius, 3);
    const double found = std::stod(note.substr(note.find(' ')));
    QVERIFY2(found > 0.6 * ml && found < 1.3 * ml, note.c_str());
  }
  Seeds seeds = clicks_in(phantom_.image);
  seeds.lesions = {test::points_at(phantom_.image, {kTumour})};
  const Segmented one = segmented(phantom_.image, seeds);
  QVERIFY(has_note(one, "liver.dark_body"));
  QVERIFY(is_settled(told[0], one.labels) && !is_settled(told[1], one.labels));
  seeds.lesions.push_back(test::points_at(phantom_.image, {kLesion}));
  QVERIFY(!has_note(segmented(phantom_.image, seeds), "liver.dark_body"));
  // Who has clicked it as liver has seen it.
  seeds.lesions.clear();
  seeds.liver = test::points_at(phantom_.image, {{83, 67, 48}, {72, 80, 64}, {88, 53, 61}, kTumour, kLesion});
  QVERIFY(!has_note(segmented(phantom_.image, seeds), "liver.dark_body"));
}

void ClicksTest::ANotLiverClickBinds() {
  for (const Eigen::Vector3d& place : {Eigen::Vector3d(96, 72, 56)}) {
    Seeds seeds = clicks_in(phantom_.image);
    seeds.background = test::points_at(phantom_.image, {place});
    const Segmented result = segmented(phantom_.image, seeds);
    for (const Eigen::Vector3d& beside :
         {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 0, 0), Eigen::Vector3d(0, 0, 2)})
      QCOMPARE(label_at(result, place + beside), structure::kBackground);
    QVERIFY(!has_note(result, "seed."));
  }
}

void ClicksTest::AClickOnAnIslandIsNamed() {
  Seeds seeds = clicks_in(phantom_.image);
  seeds.liver.conservativeResize(4, 3);
  seeds.liver.row(3) = test::points_at(phantom_.image, {{10, 112, 90}}).row(0);  // in fat, far away
  QVERIFY(has_note(segmented(phantom_.image, seeds), "seed.liver_apart 4"));
}

/// How many voxels of the liver lie 6 mm and more outside of the organ and its tumour.
long beside_the_organ(const Segmented& result) {
  const VolumeGrid& grid = result.labels.voxels.grid();
  const std::vector<std::uint8_t> liver = inside_liver(result.labels);
  long count = 0;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Eigen::Vector3d p = Eigen::Vector3d(i, j, k).cwiseProduct(grid.spacing_mm);
        if ((p - kLiver).cwiseQuotient(Eigen::Vector3d(56, 48, 44)).norm() > 1.0 &&
            (p - kTumour).norm() > kTumourRadius + 6.0)
          count += liver[static_cast<std::size_t>(grid.offset({i, j, k}))];
      }
  return count;
}

void ClicksTest::OnFineVoxelsNoIslandIsMadeEither() {
  SegmentationOptions fine;
  fine.working_spacing_mm = 1.0;
  // In fat, 9 mm beside the organ and far from it.
  Seeds seeds = clicks_in(phantom_.image);
  seeds.liver.conservativeResize(5, 3);
  seeds.liver.bottomRows(2) = test::points_at(phantom_.image, {{125, 61, 53}, {10, 112, 90}});
  const Segmented result = segmented(phantom_.image, seeds, fine);
  QVERIFY(has_note(result, "seed.liver_apart 4") && has_note(result, "seed.liver_apart 5"));
  QCOMPARE(beside_the_organ(result), 0L);
}

void ClicksTest::InARegionClicksKeepTheirNumbers() {
  Seeds seeds = clicks_in(phantom_.image);
  seeds.liver.conservativeResize(4, 3);
  seeds.liver.row(3) = test::points_at(phantom_.image, {{10, 112, 90}}).row(0);
  const auto corners = test::points_at(phantom_.image, {{0, 0, 0}, {80, 120, 100}});  // two clicks lie beyond
  SegmentationOptions options;
  options.region = Eigen::AlignedBox3d(corners.row(0).transpose());
  options.region->extend(corners.row(1).transpose());
  QVERIFY(has_note(segmented(phantom_.image, seeds, options), "seed.liver_apart 4"));
}

void ClicksTest::WhatIsFoundNowhereLeavesWhatThereWas() {
  LabelMap kept = found_.labels;
  const auto voxels = [](const LabelMap& labels) {
    const auto mask = mask_of(labels, structure::kVenaCava);
    return std::count(mask.begin(), mask.end(), 1);
  };
  for (int i = 50; i < 54; ++i) kept.voxels.set({i, 54, 40}, structure::kVenaCava);
  QCOMPARE(voxels(kept), 4L);
  // One voxel unlike all around it is no vessel.
  Image image = phantom_.image;
  auto values = *image.voxels;
  values[static_cast<std::size_t>(image.grid.offset({52, 54, 44}))] = 900;
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(values));
  Seeds seeds = clicks_in(image);
  seeds.vena_cava = test::points_at(image, {{104, 108, 96.8}});
  const Segmented result = segmented(image, seeds, {}, &kept);
  QVERIFY(has_note(result, "vena_cava.not_found"));
  QCOMPARE(voxels(result.labels), 4L);
}

void ClicksTest::AVesselThatIsFoundNowhereStays() {
  LabelMap kept = found_.labels;
  for (int i = 50; i < 54; ++i) {
    kept.voxels.set({i, 54, 40}, structure::kPortalVein);
    kept.voxels.set({i, 10, 40}, structure::kHepaticVeins);
  }
  Seeds seeds = clicks_in(phantom_.image);
  seeds.portal_vein = test::points_at(phantom_.image, {{104, 108, 96.8}});  // in fat
  seeds.hepatic_veins = test::points_at(phantom_.image, {{104, 14, 96.8}});
  const Segmented result = segmented(phantom_.image, seeds, {}, &kept);
  for (const Label tree : {structure::kPortalVein, structure::kHepaticVeins}) {
    QVERIFY(has_note(result, structure_name(tree) + ".not_found"));
    QVERIFY(mask_of(result.labels, tree) == mask_of(kept, tree));
  }
}

void ClicksTest::ALesionThatIsFoundNowhereStays() {
  // A hand painted it, where the CT shows plain liver.
  LabelMap kept = found_.labels;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) kept.voxels.set({41 + i, 29 + j, 22 + k}, structure::kFirstLesion);
  Seeds seeds = clicks_in(phantom_.image);
  seeds.lesions = {test::points_at(phantom_.image, {{85, 61, 52}})};
  SegmentationOptions lesions;
  lesions.structures = kNoStructures;
  lesions.structures.lesions = true;
  for (const SegmentationOptions& options : {SegmentationOptions(), lesions}) {
    const Segmented result = segmented(phantom_.image, seeds, options, &kept);
    QVERIFY(has_note(result, "lesion_1.not_found"));
    QVERIFY(mask_of(result.labels, structure::kFirstLesion) == mask_of(kept, structure::kFirstLesion));
  }
}

void ClicksTest::OneMoreClickChangesNothingFarAway() {
  const Eigen::Vector3d place(77, 56, 67);  // in the parenchyma
  Seeds seeds = clicks_in(phantom_.image);
  seeds.liver.conservativeResize(4, 3);
  seeds.liver.row(3) = test::points_at(phantom_.image, {place}).row(0);
  const Segmented more = segmented(phantom_.image, seeds);
  const double voxels = static_cast<double>(std::count(phantom_.liver.begin(), phantom_.liver.end(), 1));
  const auto changed = static_cast<double>(changed_beyond(found_, more, place, 30.0));
  QVERIFY2(changed < 0.01 * voxels, qPrintable(QString::number(changed / voxels)));
  QVERIFY(dice(inside_liver(more.labels), phantom_.liver) >
          dice(inside_liver(found_.labels), phantom_.liver) - 0.003);
}

/// A result with a lesion that a hand added to.
LabelMap corrected(const Image& image, const Seeds& seeds) {
  LabelMap labels = segmented(image, seeds).labels;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) labels.voxels.set({34, 26 + j, 28 + k}, structure::kFirstLesion);
  return labels;
}

void ClicksTest::ALockedLesionStaysVoxelByVoxel() {
  Seeds seeds = clicks_in(phantom_.image);
  seeds.lesions = {test::points_at(phantom_.image, {kLesion})};
  const LabelMap kept = corrected(phantom_.image, seeds);
  SegmentationOptions options;
  options.locked = {structure::kFirstLesion};
  const Segmented again = segmented(phantom_.image, seeds, options, &kept);
  QVERIFY(mask_of(again.labels, structure::kFirstLesion) == mask_of(kept, structure::kFirstLesion));
  // Without the lock it is found anew.
  options.locked.clear();
  const Segmented anew = segmented(phantom_.image, seeds, options, &kept);
  QVERIFY(mask_of(anew.labels, structure::kFirstLesion) != mask_of(kept, structure::kFirstLesion));
}

void ClicksTest::ALockedLiverStaysVoxelByVoxel() {
  Seeds seeds = clicks_in(phantom_.image);
  seeds.lesions = {test::points_at(phantom_.image, {kLesion})};
  const LabelMap kept = corrected(phantom_.image, seeds);
  // Seeds that would give another liver, and another lesion.
  seeds.background = test::points_at(phantom_.image, {{96, 72, 56}});
  seeds.lesions.push_back(test::points_at(phantom_.image, {kTumour}));
  SegmentationOptions options;
  options.locked = {structure::kParenchyma};
  const Segmented again = segmented(phantom_.image, seeds, options, &kept);
  QVERIFY(mask_of(again.labels, structure::kParenchyma) == mask_of(kept, structure::kParenchyma));
  options.locked.clear();
  const Segmented anew = segmented(phantom_.image, seeds, options, &kept);
  QVERIFY(mask_of(anew.labels, structure::kParenchyma) != mask_of(kept, structure::kParenchyma));
}

QTEST_APPLESS_MAIN(ClicksTest)
#include "clicks_test.moc"
