// SPDX-License-Identifier: GPL-3.0-or-later
// A click on a vessel or a lesion that the labels leave out, on a phantom whose truth is a formula.
#include "glisson/segmentation/grow_around.h"

#include <QTest>
#include <algorithm>
#include <random>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/random.h"
#include "glisson/segmentation/added_clicks.h"
#include "noisy_ct.h"
#include "points_at.h"

using namespace glisson;
using namespace glisson::segmentation;

namespace {

using Vec = Eigen::Vector3d;

constexpr Label kPortal = structure::kPortalVein, kHepatic = structure::kHepaticVeins,
                kFirst = structure::kFirstLesion, kSecond = structure::kFirstLesion + 1;
const Vec kLiver(90, 75, 60);                              // mm from the corner: its middle
const Vec kBall(130, 75, 60), kOtherBall(55, 105, 60);     // of the lesions
constexpr double kRadius = 12.0;                           // mm, of both
const Vec kBranchFrom(90, 40, 60), kBranchTo(40, 50, 45);  // a branch of the portal vein that is not labelled

double to_line(const Vec& p, const Vec& a, const Vec& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}
bool in_stem(const Vec& p) { return to_line(p, {90, 40, 20}, {90, 40, 95}) < 4.5; }
bool in_branch(const Vec& p) { return to_line(p, kBranchFrom, kBranchTo) < 3.5; }
bool in_vein(const Vec& p) { return to_line(p, {100, 110, 25}, {100, 110, 95}) < 4.5; }
bool in_ball(const Vec& p, const Vec& middle) { return (p - middle).norm() < kRadius; }

/// What is in the image, and labels that leave out a branch and both lesions.
struct Patient {
  Image image;
  LabelMap truth, labels;
};

Label truth_at(const Vec& p) {
  if ((p - kLiver).cwiseQuotient(Vec(75, 62, 50)).norm() >= 1.0) return structure::kBackground;
  if (in_ball(p, kBall)) return kFirst;
  if (in_ball(p, kOtherBall)) return kSecond;
  if (in_vein(p)) return kHepatic;
  return in_stem(p) || in_branch(p) ? kPortal : structure::kParenchyma;
}

double hounsfield(Label label) {
  if (label == structure::kBackground) return -90.0;
  if (is_lesion(label)) return 60.0;
  return label == structure::kParenchyma ? 108.0 : 185.0;
}

Patient patient() {
  Patient made;
  VolumeGrid grid;
  grid.size = {120, 100, 60};
  grid.spacing_mm = {1.5, 1.5, 2.0};
  grid.origin_mm = {-80, -60, 10};
  std::vector<Label> truth, labels;
  made.image = test::noisy_ct(grid, 7, 9.0, [&](const Vec& p) {
    const Label label = truth_at(p);
    truth.push_back(label);
    const bool left_out = is_lesion(label) || (label == kPortal && !in_stem(p));
    labels.push_back(left_out ? structure::kParenchyma : label);
    return hounsfield(label);
  });
  made.truth = {LabelVolume(grid, truth), {}};
  made.labels = {LabelVolume(grid, labels), {}};
  for (const Label label : {structure::kParenchyma, kPortal, kHepatic})
    made.labels.infos.push_back(structure_info(label));
  return made;
}

/// A vein that nobody has labelled, which ends in a vena cava beside the liver, both as bright.
Label vein_and_cava_at(const Vec& p) {
  if (to_line(p, {96, 30, 60}, {96, 110, 60}) < 8.0) return structure::kVenaCava;
  const bool in_liver = p.x() > 10 && p.x() < 90 && p.y() > 10 && p.y() < 130 && p.z() > 10 && p.z() < 110;
  if (!in_liver) return structure::kBackground;
  return to_line(p, {45, 70, 60}, {90, 70, 60}) < 4.0 ? kHepatic : structure::kParenchyma;
}

/// @param knows_cava whether the labels have it, besides the parenchyma.
Patient vein_and_cava(bool knows_cava) {
  Patient made;
  VolumeGrid grid;
  grid.size = {80, 94, 60};
  grid.spacing_mm = {1.5, 1.5, 2.0};
  grid.origin_mm = {-80, -60, 10};
  std::vector<Label> labels;
  made.image = test::noisy_ct(grid, 5, 9.0, [&](const Vec& p) {
    const Label label = vein_and_cava_at(p);
    const bool is_cava = label == structure::kVenaCava;
    labels.push_back(is_cava && knows_cava                        ? label
                     : label == structure::kBackground || is_cava ? structure::kBackground
                                                                  : structure::kParenchyma);
    return is_cava ? 185.0 : hounsfield(label);
  });
  made.labels = {LabelVolume(grid, labels), {structure_info(structure::kParenchyma)}};
  return made;
}

std::vector<std::uint8_t> mask(const LabelMap& labels, Label label) {
  return labels.voxels.mask([&](Label one) { return one == label; });
}

StructureClick click_on(const Image& image, Label structure, const Vec& mm) {
  return {structure, Point<CtFrame>(Vec(test::points_at(image, {mm}).row(0).transpose()))};
}

Seeds with(const StructureClick& click, double diameter_mm = 0.0) {
  Seeds seeds;
  const auto n = static_cast<std::size_t>(click.structure - structure::kFirstLesion);
  seeds.lesions.assign(n + 1, PointsIn<CtFrame>(0, 3));
  seeds.lesions[n] = click.p_in_ct.xyz.transpose();
  seeds.lesion_diameters_mm.assign(n + 1, 0.0);
  seeds.lesion_diameters_mm[n] = diameter_mm;
  return seeds;
}

}  // namespace

class GrowAroundTest : public QObject {
  Q_OBJECT
 private slots:
  void ALesionIsFoundAndNothingElseChanges();
  void ALesionThatWasFoundWronglyIsFoundAnew();
  void OfALesionThatRanOnNothingIsLeft();
  void ABranchJoinsTheTreeAndNothingIsLost();
  void WhereNothingIsNothingChanges();
  void FromAClickInTheCavaNothingGrows();
  void OfTheWholeNothingIsToldByAPart();
  void WhatIsLockedIsSaid();
  void OnlyNewClicksCount();
  void ClicksThatWereSavedAndReadAreNotNew();

 private:
  const Patient patient_ = patient();
};

void GrowAroundTest::ALesionIsFoundAndNothingElseChanges() {
  const StructureClick click = click_on(patient_.image, kSecond, kOtherBall + Vec(3, -2, 2));
  const auto made =
      grow_around(patient_.image, patient_.labels, with(click), click, {}, RunContext()).value();
  const double found = dice(mask(made.labels, kSecond), mask(patient_.truth, kSecond));
  QVERIFY2(found > 0.9, qPrintable(QString::number(found)));
  QVERIFY(made.notes.empty());
  QVERIFY2(made.reach_mm > kRadius && made.reach_mm < 2.0 * kRadius,
           qPrintable(QString::number(made.reach_mm)));
  const std::vector<Label> before = patient_.labels.voxels.dense(), after = made.labels.voxels.dense();
  long changed = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] == after[i]) continue;
    ++changed;
    QVERIFY(after[i] == kSecond && before[i] == structure::kParenchyma);
  }
  QCOMPARE(made.voxels_changed, changed);
  QVERIFY(std::any_of(made.labels.infos.begin(), made.labels.infos.end(),
                      [](const LabelInfo& info) { return info.code == kSecond; }));
}

void GrowAroundTest::ALesionThatWasFoundWronglyIsFoundAnew() {
  // The first lesion lies 10 mm beside where it is.
  LabelMap wrong = patient_.labels;
  const std::vector<std::uint8_t> truth = mask(patient_.truth, kFirst);
  const VolumeGrid& grid = patient_.image.grid;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i)
        if (in_ball(Vec(i, j, k).cwiseProduct(grid.spacing_mm), kBall + Vec(0, -10, 0)))
          wrong.voxels.set({i, j, k}, kFirst);
  const StructureClick click = click_on(patient_.image, kFirst, kBall);
  const auto made =
      grow_around(patient_.image, wrong, with(click, 2.0 * kRadius), click, {}, RunContext()).value();
  QVERIFY(dice(mask(wrong, kFirst), truth) < 0.7);
  const double found = dice(mask(made.labels, kFirst), truth);
  QVERIFY2(found > 0.9, qPrintable(QString::number(found)));
  // What it has no more is liver again.
  QCOMPARE(inside_liver(made.labels), inside_liver(wrong));
}

void GrowAroundTest::OfALesionThatRanOnNothingIsLeft() {
  // It ran 80 mm through the liver. Its drawn diameter asks for a look at the first 37 mm only.
  LabelMap wrong = patient_.labels;
  const VolumeGrid& grid = patient_.image.grid;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Vec p = Vec(i, j, k).cwiseProduct(grid.spacing_mm);
        if (wrong.voxels.at({i, j, k}) == structure::kParenchyma &&
            to_line(p, kBall, kBall - Vec(80, 0, 0)) < kRadius)
          wrong.voxels.set({i, j, k}, kFirst);
      }
  const StructureClick click = click_on(patient_.image, kFirst, kBall);
  const auto made =
      grow_around(patient_.image, wrong, with(click, 2.0 * kRadius), click, {}, RunContext()).value();
  const double found = dice(mask(made.labels, kFirst), mask(patient_.truth, kFirst));
  QVERIFY2(found > 0.9, qPrintable(QString::number(found)));
  QCOMPARE(inside_liver(made.labels), inside_liver(wrong));
  const std::vector<Label> before = wrong.voxels.dense(), after = made.labels.voxels.dense();
  long changed = 0;
  for (std::size_t i = 0; i < before.size(); ++i) changed += before[i] != after[i];
  QCOMPARE(made.voxels_changed, changed);
  QVERIFY2(made.reach_mm > 80.0, qPrintable(QString::number(made.reach_mm)));
  // Where nothing is found, it stays.
  const StructureClick nowhere = click_on(patient_.image, kFirst, Vec(90, 75, 85));
  const auto same = grow_around(patient_.image, wrong, with(nowhere), nowhere, {}, RunContext()).value();
  QCOMPARE(same.voxels_changed, 0L);
  QVERIFY(same.labels.voxels == wrong.voxels);
}

void GrowAroundTest::ABranchJoinsTheTreeAndNothingIsLost() {
  const Vec at = 0.5 * (kBranchFrom + kBranchTo);
  const auto made = grow_around(patient_.image, patient_.labels, {}, click_on(patient_.image, kPortal, at),
                                {}, RunContext())
                        .value();
  QVERIFY(made.notes.empty());
  const std::vector<Label> before = patient_.labels.voxels.dense(), after = made.labels.voxels.dense(),
                           truth = patient_.truth.voxels.dense();
  long right = 0, wrong = 0, missed = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] == after[i]) {
      missed += truth[i] == kPortal && after[i] != kPortal;
      continue;
    }
    QVERIFY(after[i] == kPortal && before[i] == structure::kParenchyma);
    ++(truth[i] == kPortal ? right : wrong);
  }
  const QString counts = QString("%1 right, %2 wrong, %3 missed").arg(right).arg(wrong).arg(missed);
  QVERIFY2(missed < 0.15 * static_cast<double>(right) && wrong < 0.3 * static_cast<double>(right),
           qPrintable(counts));
}

void GrowAroundTest::WhereNothingIsNothingChanges() {
  // The first in plain liver, the second in fat, where no liver is near.
  for (const auto& [structure, place] : {std::pair(kFirst, Vec(90, 75, 85)), {kPortal, Vec(2, 2, 2)}}) {
    const StructureClick click = click_on(patient_.image, structure, place);
    const Seeds seeds = is_lesion(structure) ? with(click) : Seeds{};
    const auto made = grow_around(patient_.image, patient_.labels, seeds, click, {}, RunContext()).value();
    QCOMPARE(made.voxels_changed, 0L);
    QCOMPARE(made.labels.voxels.dense(), patient_.labels.voxels.dense());
    QVERIFY(std::count(made.notes.begin(), made.notes.end(), structure_name(structure) + ".not_found") == 1);
  }
}

/// The cava's wall is a source of the veins, whose own click may be beside all of them.
void GrowAroundTest::FromAClickInTheCavaNothingGrows() {
  const Patient p = vein_and_cava(true);
  const StructureClick in_cava = click_on(p.image, kHepatic, {96, 70, 60});
  Seeds seeds;
  seeds.hepatic_veins = test::points_at(p.image, {{60, 70, 60}, {96, 70, 60}});
  const auto nothing = grow_around(p.image, p.labels, seeds, in_cava, {}, RunContext()).value();
  QCOMPARE(nothing.voxels_changed, 0L);
  QCOMPARE(nothing.notes.size(), std::size_t{1});
  QVERIFY2(nothing.notes[0] == "hepatic_veins.not_found" ||
               nothing.notes[0] == "hepatic_veins.click_without_effect 2",
           nothing.notes[0].c_str());
  const StructureClick in_vein = click_on(p.image, kHepatic, {60, 70, 60});
  QVERIFY(grow_around(p.image, p.labels, seeds, in_vein, {}, RunContext())->voxels_changed > 100);
}

/// Of the whole it is told that the vena cava should be clicked; in a part it may only lie beside.
void GrowAroundTest::OfTheWholeNothingIsToldByAPart() {
  const Patient p = vein_and_cava(false);
  const StructureClick click = click_on(p.image, kHepatic, {60, 70, 60});
  const auto made = grow_around(p.image, p.labels, {}, click, {}, RunContext()).value();
  const std::vector<std::uint8_t> liver = inside_liver(made.labels), veins = mask(made.labels, kHepatic);
  long beyond = 0;
  for (std::size_t i = 0; i < veins.size(); ++i) beyond += veins[i] != 0 && liver[i] == 0;
  QVERIFY2(1e-3 * static_cast<double>(beyond) * p.image.grid.voxel_volume_mm3() > 5.0,
           qPrintable(QString::number(beyond)));
  QVERIFY2(made.notes.empty(), made.notes.empty() ? "" : made.notes[0].c_str());
}

void GrowAroundTest::WhatIsLockedIsSaid() {
  const StructureClick click = click_on(patient_.image, kPortal, 0.5 * (kBranchFrom + kBranchTo));
  for (const Label locked : {kPortal, structure::kParenchyma})
    QVERIFY_THROWS_EXCEPTION(InputError,
                             grow_around(patient_.image, patient_.labels, {}, click, {locked}, RunContext()));
  const StructureClick outside = click_on(patient_.image, kPortal, Vec(-30, 0, 0));
  QVERIFY_THROWS_EXCEPTION(InputError,
                           grow_around(patient_.image, patient_.labels, {}, outside, {}, RunContext()));
}

void GrowAroundTest::OnlyNewClicksCount() {
  const StructureClick first = click_on(patient_.image, kFirst, kBall),
                       second = click_on(patient_.image, kSecond, kOtherBall),
                       vein = click_on(patient_.image, kHepatic, Vec(100, 110, 60));
  Seeds before = with(first);
  Seeds after = with(second);
  after.lesions[0] = before.lesions[0];
  after.hepatic_veins = vein.p_in_ct.xyz.transpose();
  QVERIFY((structure_clicks_added(before, after) == std::vector<StructureClick>{vein, second}));
  QVERIFY(structure_clicks_added(after, after).empty());
  QVERIFY_THROWS_EXCEPTION(InputError, added_clicks(after, after, "seeds.json"));
  // One of either kind is enough.
  QVERIFY(
      (added_clicks(before, after, "seeds.json").structures == std::vector<StructureClick>{vein, second}));
  Seeds beside = after;
  beside.background = vein.p_in_ct.xyz.transpose();
  QCOMPARE(added_clicks(after, beside, "seeds.json").liver.size(), std::size_t{1});
  // The same place, drawn wider.
  before = after;
  after.lesion_diameters_mm = {25.0, 0.0};
  QVERIFY((structure_clicks_added(before, after) == std::vector<StructureClick>{first}));
}

/// A file holds millimetres, and each saving and reading may change a metre's last bit: on the command line a
/// lesion was found anew although nobody had clicked it again.
void GrowAroundTest::ClicksThatWereSavedAndReadAreNotNew() {
  std::mt19937_64 random(7);
  const auto somewhere = [&](int count) {
    Points points(count, 3);
    for (int n = 0; n < count; ++n)
      for (int axis = 0; axis < 3; ++axis) points(n, axis) = 0.3 * uniform01(random) - 0.15;
    return points;
  };
  Seeds seeds;
  seeds.liver = somewhere(200);
  seeds.background = somewhere(200);
  seeds.portal_vein = somewhere(200);
  seeds.lesions = {somewhere(200), somewhere(1)};
  const TemporaryFolder folder;
  const auto saved = [&](const Seeds& these) {
    write_seeds(folder.path() / "seeds.json", these);
    return read_seeds(folder.path() / "seeds.json");
  };
  const Seeds once = saved(seeds);
  const Seeds twice = saved(once);
  QVERIFY(clicks_added(twice, once).empty());
  QVERIFY(structure_clicks_added(twice, once).empty());
  // A click a hundredth of a millimetre beside another one is a click.
  Seeds more = once;
  more.lesions[0].row(0) += Eigen::RowVector3d(1e-5, 0.0, 0.0);
  more.liver.row(0) += Eigen::RowVector3d(1e-5, 0.0, 0.0);
  QCOMPARE(structure_clicks_added(twice, more).size(), std::size_t{1});
  QCOMPARE(clicks_added(twice, more).size(), std::size_t{1});
}

QTEST_GUILESS_MAIN(GrowAroundTest)
#include "grow_around_test.moc"
