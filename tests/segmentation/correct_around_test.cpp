// SPDX-License-Identifier: GPL-3.0-or-later
// One click corrects the labels around it, and nothing else, on a phantom that is known.
#include "glisson/segmentation/correct_around.h"

#include <QTest>

#include "complaint.h"
#include "glisson/core/error.h"
#include "noisy_ct.h"
#include "points_at.h"

using namespace glisson;
using namespace glisson::segmentation;

namespace {

const Eigen::Vector3d kLiver(76, 71, 60), kTumour(69, 40, 56), kStomach(136, 71, 60);  // mm
constexpr double kTumourRadius = 19.0, kStomachRadius = 22.0;

/// An ellipsoid of 108 HU in fat, a dark tumour at its rim that sticks out, and a stomach that leans on it.
struct Phantom {
  Image image;
  std::vector<std::uint8_t> liver, tumour, stomach;
};

Phantom phantom() {
  Phantom result;
  VolumeGrid grid;
  grid.size = {110, 98, 60};
  grid.spacing_mm = {1.5, 1.5, 2.0};
  grid.origin_mm = {-90, -60, 20};
  result.image = test::noisy_ct(grid, 7, 10.0, [&](const Eigen::Vector3d& p) {
    const bool tumour = (p - kTumour).norm() < kTumourRadius;
    const bool liver = tumour || (p - kLiver).cwiseQuotient(Eigen::Vector3d(44, 42, 38)).norm() < 1.0;
    const bool stomach = !liver && (p - kStomach).norm() < kStomachRadius;
    result.liver.push_back(liver);
    result.tumour.push_back(tumour);
    result.stomach.push_back(stomach);
    const double hu = tumour ? 62.0 : liver ? 108.0 : stomach ? 45.0 : -95.0;
    return hu;
  });
  return result;
}

template <class Wanted>
LabelMap labels_of(const Phantom& phantom, const Wanted& wanted) {
  std::vector<Label> dense;
  for (std::size_t i = 0; i < phantom.liver.size(); ++i)
    dense.push_back(wanted(i) ? structure::kParenchyma : Label{0});
  return {LabelVolume(phantom.image.grid, dense), {structure_info(structure::kParenchyma)}};
}

Click click_at(const Image& image, const Eigen::Vector3d& mm, bool is_liver) {
  return {Point<CtFrame>(Eigen::Vector3d(test::points_at(image, {mm}).row(0).transpose())), is_liver};
}

Label label_at(const LabelMap& labels, const Eigen::Vector3d& mm) {
  return labels.voxels.at(
      mm.cwiseQuotient(labels.voxels.grid().spacing_mm).array().round().matrix().cast<int>());
}

/// How far from a click the farthest voxel lies that differs, mm.
double farthest_change(const LabelMap& a, const LabelMap& b, const Click& click) {
  const VolumeGrid& grid = a.voxels.grid();
  double farthest = 0.0;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i)
        if (a.voxels.at({i, j, k}) != b.voxels.at({i, j, k}))
          farthest = std::max(farthest,
                              1e3 * (grid.p_in_ct(Eigen::Vector3d(i, j, k)).xyz - click.p_in_ct.xyz).norm());
  return farthest;
}

}  // namespace

class CorrectAroundTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void AMissedTumourComesWithOneClick();
  void ALeakGoesWithOneClick();
  void WhatIsRightAlreadyStaysTheSameEdition();
  void NothingChangesBeyondTheReach();
  void AClickOnAnIslandIsNamedAndChangesNothing();
  void OtherClicksHold();
  void AClickBindsHoweverNearAnotherLies();
  void AClickThatNothingSpeaksForTakesOnlyItsSurroundings();
  void OtherStructuresAndLocksStay();
  void AClickInAnotherStructureSaysWhatLiesThere();
  void AnMriIsCorrectedAsACtIs();
  void WhatCannotBeIsRefused();
  void CancelledIsEmpty();
  void AddedClicksAreThoseThatWereNotThere();

 private:
  CorrectedAround corrected(const LabelMap& labels, const Click& click, const Seeds& seeds = {},
                            const std::vector<Label>& locked = {}) {
    return correct_around(phantom_.image, labels, seeds, click, locked, RunContext()).value();
  }
  double agreement(const LabelMap& labels) { return dice(inside_liver(labels), phantom_.liver); }

  Phantom phantom_;
  LabelMap truth_, no_tumour_, leaked_;
  Click tumour_, stomach_;
};

void CorrectAroundTest::initTestCase() {
  phantom_ = phantom();
  truth_ = labels_of(phantom_, [&](std::size_t i) { return phantom_.liver[i] != 0; });
  no_tumour_ = labels_of(phantom_, [&](std::size_t i) { return phantom_.liver[i] && !phantom_.tumour[i]; });
  leaked_ = labels_of(phantom_, [&](std::size_t i) { return phantom_.liver[i] || phantom_.stomach[i]; });
  tumour_ = click_at(phantom_.image, kTumour + Eigen::Vector3d(3, -4, 2), true);
  stomach_ = click_at(phantom_.image, kStomach + Eigen::Vector3d(4, 3, -3), false);
}

void CorrectAroundTest::AMissedTumourComesWithOneClick() {
  QVERIFY(agreement(no_tumour_) < 0.95);
  const CorrectedAround result = corrected(no_tumour_, tumour_);
  QVERIFY2(agreement(result.labels) > 0.99, qPrintable(QString::number(agreement(result.labels))));
  QVERIFY(result.notes.empty());
}

void CorrectAroundTest::ALeakGoesWithOneClick() {
  QVERIFY(agreement(leaked_) < 0.95);
  const CorrectedAround result = corrected(leaked_, stomach_);
  QVERIFY2(agreement(result.labels) > 0.99, qPrintable(QString::number(agreement(result.labels))));
  QVERIFY(result.notes.empty());
}

void CorrectAroundTest::WhatIsRightAlreadyStaysTheSameEdition() {
  const CorrectedAround result = corrected(truth_, click_at(phantom_.image, kLiver, true));
  QCOMPARE(result.voxels_changed, 0L);
  QVERIFY(result.labels.voxels.changes_since(truth_.voxels).empty());
}

void CorrectAroundTest::NothingChangesBeyondTheReach() {
  for (const bool is_liver : {true, false}) {
    const LabelMap& before = is_liver ? no_tumour_ : leaked_;
    const Click& click = is_liver ? tumour_ : stomach_;
    const CorrectedAround result = corrected(before, click);
    QVERIFY(result.voxels_changed > 1000);
    QVERIFY(std::abs(farthest_change(before, result.labels, click) - result.reach_mm) < 1e-6);
    QVERIFY(result.reach_mm < 65.0);
  }
  // A shallow error is corrected shallowly: 4 mm beside the border, in fat.
  const Click beside = click_at(phantom_.image, kLiver + Eigen::Vector3d(0, 46, 0), true);
  const CorrectedAround result = corrected(truth_, beside);
  QVERIFY(label_at(result.labels, kLiver + Eigen::Vector3d(0, 46, 0)) == structure::kParenchyma);
  QVERIFY2(result.reach_mm < 12.0, qPrintable(QString::number(result.reach_mm)));
}

void CorrectAroundTest::AClickOnAnIslandIsNamedAndChangesNothing() {
  Seeds seeds;
  seeds.liver = test::points_at(phantom_.image, {kLiver, {10, 132, 105}});
  const CorrectedAround result =
      corrected(truth_, {Point<CtFrame>(Eigen::Vector3d(seeds.liver.row(1).transpose())), true}, seeds);
  QCOMPARE(result.notes, std::vector<std::string>{"seed.liver_apart 2"});
  QCOMPARE(result.voxels_changed, 0L);
}

void CorrectAroundTest::OtherClicksHold() {
  const Eigen::Vector3d held = kTumour + Eigen::Vector3d(-9, -9, 0);
  Seeds seeds;
  seeds.background = test::points_at(phantom_.image, {held});
  QCOMPARE(label_at(corrected(no_tumour_, tumour_).labels, held), structure::kParenchyma);
  const LabelMap labels = corrected(no_tumour_, tumour_, seeds).labels;
  QCOMPARE(label_at(labels, held), structure::kBackground);
  QCOMPARE(label_at(labels, kTumour), structure::kParenchyma);
}

void CorrectAroundTest::AClickBindsHoweverNearAnotherLies() {
  for (const double away : {2.0, 3.0, 5.0, 9.0}) {
    Seeds seeds;
    seeds.background = test::points_at(phantom_.image, {kLiver});
    const LabelMap holed = corrected(truth_, click_at(phantom_.image, kLiver, false), seeds).labels;
    QCOMPARE(label_at(holed, kLiver), structure::kBackground);
    const Eigen::Vector3d beside = kLiver + Eigen::Vector3d(away, 0.0, 0.0);
    const LabelMap mended = corrected(holed, click_at(phantom_.image, beside, true), seeds).labels;
    QCOMPARE(label_at(mended, beside), structure::kParenchyma);
    QCOMPARE(label_at(mended, kLiver), structure::kBackground);
  }
}

/// "Not liver" in the middle of tissue that is liver's: a slip of the hand takes no liver away.
void CorrectAroundTest::AClickThatNothingSpeaksForTakesOnlyItsSurroundings() {
  const CorrectedAround result = corrected(truth_, click_at(phantom_.image, kLiver, false));
  QCOMPARE(label_at(result.labels, kLiver), structure::kBackground);
  QVERIFY2(result.reach_mm < 8.0, qPrintable(QString::number(result.reach_mm)));
}

void CorrectAroundTest::OtherStructuresAndLocksStay() {
  // A gallbladder painted into the tumour, and a lesion into the leak.
  LabelMap labels = no_tumour_, leaked = leaked_;
  for (int k = -3; k <= 3; ++k)
    for (int j = -3; j <= 3; ++j)
      for (int i = -3; i <= 3; ++i) {
        const Eigen::Vector3d mm(1.5 * i, 1.5 * j, 2.0 * k);
        const auto voxel = [&](const Eigen::Vector3d& p) {
          return Eigen::Vector3i(
              (p + mm).cwiseQuotient(phantom_.image.grid.spacing_mm).array().round().matrix().cast<int>());
        };
        labels.voxels.set(voxel(kTumour + Eigen::Vector3d(-8, 0, 0)), structure::kGallbladder);
        leaked.voxels.set(voxel(kStomach + Eigen::Vector3d(0, -10, 0)), structure::kFirstLesion);
      }
  const auto count = [](const LabelMap& map, Label label) {
    const auto all = map.voxels.histogram();
    return label < all.size() ? all[label] : 0L;
  };
  const CorrectedAround with = corrected(labels, tumour_);
  QCOMPARE(count(with.labels, structure::kGallbladder), count(labels, structure::kGallbladder));
  QVERIFY(with.voxels_changed > 1000);
  const CorrectedAround locked = corrected(leaked, stomach_, {}, {structure::kFirstLesion});
  QCOMPARE(count(locked.labels, structure::kFirstLesion), count(leaked, structure::kFirstLesion));
  QCOMPARE(count(corrected(leaked, stomach_).labels, structure::kFirstLesion), 0L);
}

void CorrectAroundTest::AClickInAnotherStructureSaysWhatLiesThere() {
  LabelMap labels = no_tumour_;
  const auto voxel = [&](const Eigen::Vector3d& mm) {
    return Eigen::Vector3i(
        mm.cwiseQuotient(phantom_.image.grid.spacing_mm).array().round().matrix().cast<int>());
  };
  for (int k = -6; k <= 6; ++k)
    for (int j = -6; j <= 6; ++j)
      for (int i = -6; i <= 6; ++i)
        labels.voxels.set(voxel(kTumour + Eigen::Vector3d(1.5 * i, 1.5 * j, 2.0 * k)), structure::kVenaCava);
  // In its middle, and two millimetres before its border.
  for (const double off : {0.0, 7.0}) {
    const CorrectedAround taken =
        corrected(labels, click_at(phantom_.image, kTumour + Eigen::Vector3d(off, 0, 0), true));
    QCOMPARE(taken.notes, std::vector<std::string>{"seed.liver_taken 1 vena_cava"});
    QCOMPARE(taken.voxels_changed, 0L);
    QVERIFY(taken.labels.voxels == labels.voxels);
  }
  LabelMap lesion = leaked_;
  lesion.voxels.set(voxel(kStomach), structure::kFirstLesion);
  const CorrectedAround locked =
      corrected(lesion, click_at(phantom_.image, kStomach, false), {}, {structure::kFirstLesion});
  QCOMPARE(locked.notes, std::vector<std::string>{"seed.not_liver_taken 1 lesion_1"});
  QCOMPARE(locked.voxels_changed, 0L);
}

void CorrectAroundTest::AnMriIsCorrectedAsACtIs() {
  Image mri = phantom_.image;
  mri.modality = Modality::mr;
  std::vector<std::int16_t> greys = *mri.voxels;
  for (auto& v : greys) v = static_cast<std::int16_t>(400 + 2 * v);
  mri.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(greys));
  const auto result = correct_around(mri, no_tumour_, {}, tumour_, {}, RunContext());
  QVERIFY2(agreement(result->labels) > 0.985, qPrintable(QString::number(agreement(result->labels))));
}

void CorrectAroundTest::WhatCannotBeIsRefused() {
  const auto complaint = [&](const LabelMap& labels, const Click& click, const std::vector<Label>& locked) {
    return test::complaint([&] { corrected(labels, click, {}, locked); });
  };
  QCOMPARE(complaint(truth_, click_at(phantom_.image, {-500, 0, 0}, true), {}),
           std::string("seeds: liver: lies outside the image. Check that the seeds belong to this image and "
                       "are in mm (LPS)."));
  QCOMPARE(complaint(truth_, tumour_, {structure::kParenchyma}),
           std::string("labels: liver: is locked. Unlock it, or click another structure."));
  VolumeGrid other = phantom_.image.grid;
  other.size.x() -= 1;
  QVERIFY(!complaint({LabelVolume(other), {}}, tumour_, {}).empty());
}

void CorrectAroundTest::CancelledIsEmpty() {
  const auto cancel = std::make_shared<CancelFlag>();
  cancel->request();
  QVERIFY(!correct_around(phantom_.image, no_tumour_, {}, tumour_, {}, RunContext({}, cancel, 1)));
}

void CorrectAroundTest::AddedClicksAreThoseThatWereNotThere() {
  Seeds before, after;
  before.liver = test::points_at(phantom_.image, {kLiver});
  after.liver = test::points_at(phantom_.image, {kLiver, kTumour});
  after.background = test::points_at(phantom_.image, {kStomach});
  const std::vector<Click> added = clicks_added(before, after);
  QVERIFY(added == (std::vector<Click>{click_at(phantom_.image, kTumour, true),
                                       click_at(phantom_.image, kStomach, false)}));
  QVERIFY(clicks_added(after, after).empty());
}

QTEST_APPLESS_MAIN(CorrectAroundTest)
#include "correct_around_test.moc"
