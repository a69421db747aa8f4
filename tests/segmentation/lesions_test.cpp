// SPDX-License-Identifier: GPL-3.0-or-later
// What one click makes of a lesion, on phantoms whose truth is a formula.
#include <QTest>

#include "glisson/core/error.h"
#include "glisson/segmentation/segment.h"
#include "noisy_ct.h"
#include "points_at.h"

using namespace glisson;
using namespace glisson::segmentation;

namespace {

using Vec = Eigen::Vector3d;

const Vec kMiddle(60, 54, 50);  // mm from the corner
constexpr double kRadius = 13.0, kLiver = 108.0;
const Eigen::Vector2d kVein(60.0, 54.0 - 0.9 * kRadius - 3.0);  // along z
constexpr double kVeinRadius = 4.0;

/// A liver with one lesion, an ellipsoid, and a vessel of 170 HU and 4 mm that touches it; noise of 12 HU.
struct Phantom {
  Image image;
  LabelMap kept;  ///< the whole liver, without the lesion
  std::vector<std::uint8_t> lesion;
};

/// @param look HU at a place `f` mm from the lesion's boundary, negative inside. @param blur_mm of the edge
/// between lesion and liver: sigma of an even point spread.
Phantom phantom(const std::function<double(const Vec&, double f)>& look, double blur_mm = 0.0) {
  Phantom result;
  VolumeGrid grid;
  grid.size = {80, 72, 50};
  grid.spacing_mm = {1.5, 1.5, 2.0};
  grid.origin_mm = {-60, -50, 20};
  std::vector<Label> labels;
  result.image = test::noisy_ct(grid, 11, 12.0, [&](const Vec& p) {
    const bool liver = (p - kMiddle).cwiseQuotient(Vec(52, 46, 42)).norm() < 1.0;
    const double f = ((p - kMiddle).cwiseQuotient(Vec(1.15, 0.9, 1.0)).norm() - kRadius);
    const bool vessel = (p.head<2>() - kVein).norm() < kVeinRadius;
    double hu = liver ? kLiver : -90.0;
    if (vessel && liver) hu = 170.0;
    if (f < 0.0 && blur_mm == 0.0) hu = look(p, f);
    const double share = blur_mm > 0.0 ? 0.5 * std::erfc(f / (std::sqrt(2.0) * blur_mm)) : 0.0;
    if (blur_mm > 0.0 && liver && !vessel) hu += share * (look(p, f) - hu);
    result.lesion.push_back(f < 0.0 ? 1 : 0);
    labels.push_back(liver ? structure::kParenchyma : structure::kBackground);
    return hu;
  });
  result.kept.voxels = LabelVolume(grid, labels);
  result.kept.infos = {structure_info(structure::kParenchyma)};
  return result;
}

struct Grown {
  double dice = 0.0, ml = 0.0;
  std::vector<std::string> notes;
  bool says(const char* note) const { return std::find(notes.begin(), notes.end(), note) != notes.end(); }
};
double ball_ml(double diameter_mm) { return M_PI / 6.0 * std::pow(diameter_mm, 3) * 1e-3; }
/// @param off from the lesion's middle, mm.
Grown grown(const Phantom& phantom, const Vec& off, double diameter_mm = 0.0) {
  Seeds seeds;
  seeds.lesions = {test::points_at(phantom.image, {kMiddle + off})};
  if (diameter_mm > 0.0) seeds.lesion_diameters_mm = {diameter_mm};
  SegmentationOptions options;
  options.structures = {false, false, false, false, false, true};
  const Segmented found = segment(phantom.image, seeds, options, RunContext(), &phantom.kept).value();
  const auto is_it = [](Label label) { return label == structure::kFirstLesion; };
  return {dice(found.labels.voxels.mask(is_it), phantom.lesion), found.report.lesion_ml.front(),
          found.report.notes};
}

double dark(const Vec&, double) { return 60.0; }

/// A ball of 65 HU in a round liver of 110 HU and 48 mm in fat, as a scanner shows them: both borders are
/// abrupt, blurred by its point spread (0.8 mm) and by the voxels that average.
struct RoundCt {
  Image image;
  LabelMap kept;
  std::vector<std::uint8_t> lesion;
  Vec middle;
};
/// @param deep_mm the ball's middle lies under the liver's surface.
RoundCt round_ct(double spacing_mm, double radius_mm, double deep_mm) {
  constexpr double kRound = 48.0, kHalf = 55.0, kPointSpread = 0.8;
  const double blur = std::sqrt(kPointSpread * kPointSpread + spacing_mm * spacing_mm / 12.0);
  const Vec liver = Vec::Constant(kHalf);
  RoundCt made;
  made.middle = liver + Vec(kRound - deep_mm + 0.37, -0.61, 0.23);
  VolumeGrid grid;
  grid.size = Eigen::Vector3i::Constant(static_cast<int>(2.0 * kHalf / spacing_mm));
  grid.spacing_mm = Vec::Constant(spacing_mm);
  const auto share = [&](double outside_mm) { return 0.5 * std::erfc(outside_mm / (std::sqrt(2.0) * blur)); };
  std::vector<Label> labels;
  made.image = test::noisy_ct(grid, 3, 14.0, [&](const Vec& p) {
    const double to_liver = (p - liver).norm() - kRound, to_ball = (p - made.middle).norm() - radius_mm;
    labels.push_back(to_liver < 0.0 ? structure::kParenchyma : structure::kBackground);
    made.lesion.push_back(to_liver < 0.0 && to_ball < 0.0 ? 1 : 0);
    return -90.0 + share(to_liver) * (200.0 - 45.0 * share(to_ball));
  });
  made.kept.voxels = LabelVolume(grid, labels);
  made.kept.infos = {structure_info(structure::kParenchyma)};
  return made;
}
/// ml is a share of the true one. @param drawn its diameter, too.
Grown grown_in(const RoundCt& made, double radius_mm, bool drawn) {
  Seeds seeds;
  seeds.lesions = {test::points_at(made.image, {made.middle + 0.2 * radius_mm * Vec(-1, 1, -0.5)})};
  if (drawn) seeds.lesion_diameters_mm = {2.1 * radius_mm};
  SegmentationOptions options;
  options.structures = {false, false, false, false, false, true};
  const Segmented found = segment(made.image, seeds, options, RunContext(), &made.kept).value();
  const double true_ml = 1e-3 * static_cast<double>(std::count(made.lesion.begin(), made.lesion.end(), 1)) *
                         made.image.grid.voxel_volume_mm3();
  const auto is_it = [](Label label) { return label == structure::kFirstLesion; };
  return {dice(found.labels.voxels.mask(is_it), made.lesion), found.report.lesion_ml.front() / true_ml,
          found.report.notes};
}

/// What of the true lesion was found, as a sentence.
QString words_of(const Grown& one, double spacing_mm, double radius_mm, double deep_mm) {
  return QString("voxels of %1 mm, radius %2, %3 mm deep: %4 of it, Dice %5")
      .arg(spacing_mm)
      .arg(radius_mm)
      .arg(deep_mm)
      .arg(one.ml)
      .arg(one.dice);
}

}  // namespace

class LesionsTest : public QObject {
  Q_OBJECT
 private slots:
  void OneClickAnywhereFindsIt_data();
  void OneClickAnywhereFindsIt();
  void ABlurredEdgeIsNotTheLesions();
  void AnAbruptBorderIsHalfWayDown();
  void TheMixtureUnderTheSurfaceIsNotTheLesions();
  void LiverOverALesionIsNotFilledUp();
  void ALayerThatIsNotSeenIsTold();
  void WhatIsNoLesionIsNotFound();
  void ClicksInVainAreCounted();
  void APieceOfAVeinIsTold();
  void ABrightLesionIsToldWhereNoVeinIsKnown();
  void ADarkLesionAroundAVeinIsNoPieceOfIt();
  void AFaintRimIsFoundOrSaid();
  void ANecrosisHasItsLivingRim();
  void ADiameterFindsWhatCannotBeSeen();
  void ADiameterBoundsIt();
  void ADiameterDoesNotHideABorder();
  void ALesionInAHandsOtherUnitsIsRefused();
  void ALesionLargerThanAClickLooksIsTold();
};

void LesionsTest::OneClickAnywhereFindsIt_data() {
  using Look = std::function<double(const Vec&, double)>;
  QTest::addColumn<Look>("look");
  QTest::newRow("hypodense") << Look(dark);
  QTest::newRow("necrotic") << Look([](const Vec&, double f) { return f < -5.0 ? 22.0 : 72.0; });
  QTest::newRow("calcified") << Look([](const Vec& p, double) {
    return std::sin(0.9 * p.x()) * std::sin(0.9 * p.y()) * std::sin(0.7 * p.z()) > 0.5 ? 320.0 : 62.0;
  });
  QTest::newRow("rim-enhancing") << Look([](const Vec&, double f) { return f > -3.0 ? 145.0 : 50.0; });
  QTest::newRow("cyst") << Look([](const Vec&, double) { return 5.0; });
  QTest::newRow("hyperdense") << Look([](const Vec&, double) { return 155.0; });
}

void LesionsTest::OneClickAnywhereFindsIt() {
  QFETCH(std::function<double(const Vec&, double)>, look);
  const Phantom made = phantom(look);
  for (const Vec& off : {Vec(0, 0, 0), Vec(7, 2, -3), Vec(-6, -4, 4)}) {
    const Grown one = grown(made, off);
    QVERIFY2(one.dice > 0.8,
             qPrintable(QString("%1 at %2 %3 %4").arg(one.dice).arg(off.x()).arg(off.y()).arg(off.z())));
  }
}

void LesionsTest::ABlurredEdgeIsNotTheLesions() {
  // A ball's edge is blurred by a known point spread: the boundary lies nearer to it than where a tenth of
  // the step is left.
  constexpr double kBlur = 1.2, kTenth = 1.2816;  // mm; sigmas
  const Phantom made = phantom(dark, kBlur);
  const double truth = 1.15 * 0.9 * ball_ml(2.0 * kRadius);
  const double most = truth * std::pow(1.0 + kTenth * kBlur / kRadius, 3);
  const Grown one = grown(made, Vec(3, 2, -2));
  QVERIFY2(one.ml > 0.95 * truth && one.ml < most, qPrintable(QString::number(one.ml / truth)));
}

void LesionsTest::AnAbruptBorderIsHalfWayDown() {
  for (const double spacing : {1.0, 2.0})
    for (const double radius : {6.0, 8.0, 12.0}) {
      const RoundCt made = round_ct(spacing, radius, 48.0);
      for (const bool drawn : {false, true}) {
        const Grown one = grown_in(made, radius, drawn);
        QVERIFY2(std::abs(one.ml - 1.0) < 0.1 && one.dice > 0.9,
                 qPrintable(words_of(one, spacing, radius, 48.0)));
      }
    }
}

void LesionsTest::TheMixtureUnderTheSurfaceIsNotTheLesions() {
  // 2 mm under it, and cut by it: what lies within 3.4 mm of it cannot be told, the rim all around can.
  constexpr double kSpacing = 2.0, kRadius12 = 12.0;
  for (const double deep : {kRadius12 + 2.0, 0.5 * kRadius12})
    for (const bool drawn : {false, true}) {
      const Grown one = grown_in(round_ct(kSpacing, kRadius12, deep), kRadius12, drawn);
      QVERIFY2(one.ml > 0.85 && one.ml < 1.15 && one.dice > 0.88,
               qPrintable(words_of(one, kSpacing, kRadius12, deep)));
    }
}

void LesionsTest::LiverOverALesionIsNotFilledUp() {
  constexpr double kRadius8 = 8.0;
  for (const double spacing : {1.0, 2.0})
    for (const double layer : {1.0, 2.0, 4.0})
      for (const bool drawn : {false, true}) {
        const double deep = kRadius8 + layer;
        const Grown one = grown_in(round_ct(spacing, kRadius8, deep), kRadius8, drawn);
        QVERIFY2(std::abs(one.ml - 1.0) < 0.17 && one.dice > 0.9,
                 qPrintable(words_of(one, spacing, kRadius8, deep)));
      }
}

void LesionsTest::ALayerThatIsNotSeenIsTold() {
  // The image's blur of 1.4 mm, on voxels of 2 mm, leaves a hundredth 3.4 mm under the surface.
  constexpr double kSpacing = 2.0, kRadius8 = 8.0;
  const char* told = "lesion_1.under_surface 4";
  QVERIFY(grown_in(round_ct(kSpacing, kRadius8, kRadius8 + 1.0), kRadius8, false).says(told));
  QVERIFY(grown_in(round_ct(kSpacing, kRadius8, 0.0), kRadius8, true).says(told));
  QVERIFY(!grown_in(round_ct(kSpacing, kRadius8, kRadius8 + 8.0), kRadius8, false).says(told));
}

void LesionsTest::WhatIsNoLesionIsNotFound() {
  const Phantom none = phantom([](const Vec&, double) { return kLiver; });
  const Grown one = grown(none, Vec(3, 0, 2));
  QCOMPARE(one.ml, 0.0);
  QVERIFY(one.says("lesion_1.not_found"));
}

void LesionsTest::ClicksInVainAreCounted() {
  const Phantom made = phantom(dark);
  const Vec plain(26, 0, 8), also_plain(-27, 3, -6);  // in liver that nothing differs from
  const auto notes_of = [&](const std::vector<Vec>& offs) {
    Points clicks(static_cast<Eigen::Index>(offs.size()), 3);
    for (std::size_t n = 0; n < offs.size(); ++n)
      clicks.row(static_cast<Eigen::Index>(n)) = test::points_at(made.image, {kMiddle + offs[n]});
    Seeds seeds;
    seeds.lesions = {clicks};
    SegmentationOptions options;
    options.structures = {false, false, false, false, false, true};
    return segment(made.image, seeds, options, RunContext(), &made.kept).value().report.notes;
  };
  const auto told = [](const std::vector<std::string>& notes) {
    const auto note = std::ranges::find_if(
        notes, [](const std::string& one) { return one.starts_with("lesion_1.click_without_effect"); });
    return note == notes.end() ? std::string() : *note;
  };
  QCOMPARE(told(notes_of({Vec::Zero(), Vec(3, 2, 1)})), std::string());
  QCOMPARE(told(notes_of({Vec::Zero(), plain})), std::string("lesion_1.click_without_effect 1"));
  QCOMPARE(told(notes_of({plain, Vec::Zero(), also_plain})), std::string("lesion_1.click_without_effect 2"));
  QCOMPARE(told(notes_of({plain})), std::string());  // lesion_1.not_found says so
}

void LesionsTest::APieceOfAVeinIsTold() {
  // The phantom's vein without the 10 mm around the click, as where a tree was not found.
  const auto with_vein = [](Phantom made, double gap_mm) {
    const VolumeGrid& grid = made.image.grid;
    for (int k = 0; k < grid.size.z(); ++k)
      for (int j = 0; j < grid.size.y(); ++j)
        for (int i = 0; i < grid.size.x(); ++i) {
          const Vec p = Vec(i, j, k).cwiseProduct(grid.spacing_mm);
          if ((p.head<2>() - kVein).norm() < kVeinRadius && std::abs(p.z() - kMiddle.z()) > gap_mm &&
              made.kept.voxels.at({i, j, k}) != 0)
            made.kept.voxels.set({i, j, k}, structure::kHepaticVeins);
        }
    made.kept.infos.push_back(structure_info(structure::kHepaticVeins));
    return made;
  };
  const auto says = [](const Grown& one) {
    return std::any_of(one.notes.begin(), one.notes.end(),
                       [](const std::string& note) { return note.starts_with("lesion_1.perhaps_vein "); });
  };
  const Phantom none = phantom([](const Vec&, double) { return kLiver; });
  const Grown vein = grown(with_vein(none, 5.0), Vec(kVein.x(), kVein.y(), kMiddle.z()) - kMiddle);
  QVERIFY(vein.ml > 0.0 && says(vein));
  // A bright lesion that a vein passes, and a dark one.
  for (const double look : {155.0, 60.0}) {
    const Grown lesion =
        grown(with_vein(phantom([&](const Vec&, double) { return look; }), 0.0), Vec::Zero());
    QVERIFY(lesion.dice > 0.8 && !says(lesion));
  }
}

void LesionsTest::ABrightLesionIsToldWhereNoVeinIsKnown() {
  const Vec at_vein = Vec(kVein.x(), kVein.y(), kMiddle.z()) - kMiddle;
  QVERIFY(grown(phantom([](const Vec&, double) { return kLiver; }), at_vein).says("lesion_1.bright"));
  QVERIFY(grown(phantom([](const Vec&, double) { return 155.0; }), Vec::Zero()).says("lesion_1.bright"));
  QVERIFY(!grown(phantom(dark), Vec::Zero()).says("lesion_1.bright"));
}

void LesionsTest::ADarkLesionAroundAVeinIsNoPieceOfIt() {
  // A thick vein through its middle, half as wide as the lesion.
  Phantom made = phantom(dark);
  const VolumeGrid& grid = made.image.grid;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Vec off = Vec(i, j, k).cwiseProduct(grid.spacing_mm) - kMiddle;
        if (off.head<2>().norm() < 0.5 * kRadius && made.kept.voxels.at({i, j, k}) != 0)
          made.kept.voxels.set({i, j, k}, structure::kHepaticVeins);
      }
  made.kept.infos.push_back(structure_info(structure::kHepaticVeins));
  const Grown lesion = grown(made, Vec(10, 0, 0));
  QVERIFY(lesion.ml > 2.0);
  for (const std::string& note : lesion.notes) QVERIFY2(note.find("vein") == std::string::npos, note.c_str());
}

void LesionsTest::AFaintRimIsFoundOrSaid() {
  for (const double rim : {114.0, 122.0, 130.0, 140.0}) {
    const Phantom made = phantom([&](const Vec&, double f) { return f > -3.0 ? rim : kLiver; });
    const Grown one = grown(made, Vec(3, 0, 2));
    QVERIFY2(one.dice > 0.7 || (one.ml == 0.0 && one.says("lesion_1.not_found")),
             qPrintable(QString::number(rim)));
    QVERIFY(grown(made, Vec::Zero(), 2.0 * kRadius).dice > 0.75);
  }
}

void LesionsTest::ANecrosisHasItsLivingRim() {
  // 11 mm around a dead middle are 14 HU darker than the liver, which differs as much from end to end.
  constexpr double kWhole = 24.0, kDead = 13.0;
  Phantom made = phantom(dark);
  made.lesion.clear();
  made.image = test::noisy_ct(made.image.grid, 5, 12.0, [&](const Vec& p) {
    const double r = (p - kMiddle).norm();
    const bool liver = (p - kMiddle).cwiseQuotient(Vec(52, 46, 42)).norm() < 1.0;
    const double there = kLiver + 0.3 * (p - kMiddle).x();
    made.lesion.push_back(r < kWhole);
    return r < kDead ? 22.0 : r < kWhole ? there - 14.0 : liver ? there : -90.0;
  });
  for (const Vec& off : {Vec(0, 0, 0), Vec(6, -4, 3)}) {
    const double found = grown(made, off).dice;
    QVERIFY2(found > 0.8, qPrintable(QString::number(found)));
  }
}

void LesionsTest::ADiameterFindsWhatCannotBeSeen() {
  // As bright as the liver: only the hand knows.
  const Phantom hidden = phantom([](const Vec&, double) { return kLiver; });
  for (const double diameter : {12.0, 2.0 * kRadius, 40.0}) {
    const Grown one = grown(hidden, Vec(0, 0, 6), diameter);
    QVERIFY(std::abs(one.ml / ball_ml(diameter) - 1.0) < 0.05);
    QVERIFY(one.says("lesion_1.as_drawn"));
  }
}

void LesionsTest::ADiameterBoundsIt() {
  // What looks alike reaches to twice the diameter: no border lies where it ends.
  const Phantom made = phantom(dark);
  const Grown small = grown(made, Vec::Zero(), kRadius);
  QVERIFY2(std::abs(small.ml / ball_ml(kRadius) - 1.0) < 0.05, qPrintable(QString::number(small.ml)));
  QVERIFY(small.says("lesion_1.as_drawn"));
}

void LesionsTest::ADiameterDoesNotHideABorder() {
  const Phantom made = phantom(dark);
  for (const double diameter : {1.8 * kRadius, 2.0 * kRadius, 2.2 * kRadius}) {
    const Grown one = grown(made, Vec::Zero(), diameter);
    QVERIFY2(one.dice > 0.85, qPrintable(QString::number(one.dice)));
    QVERIFY(!one.says("lesion_1.as_drawn"));
  }
}

void LesionsTest::ALesionInAHandsOtherUnitsIsRefused() {
  const Phantom made = phantom(dark);
  QVERIFY_THROWS_EXCEPTION(InputError, grown(made, Vec::Zero(), 0.026));  // metres, not millimetres
}

void LesionsTest::ALesionLargerThanAClickLooksIsTold() {
  const Vec middle(126, 117, 114);
  constexpr double kHalf = 80.0;  // mm; a click looks 65 mm far
  VolumeGrid grid;
  grid.size = {84, 78, 76};
  grid.spacing_mm = {3.0, 3.0, 3.0};
  std::vector<Label> labels;
  const Image image = test::noisy_ct(grid, 13, 12.0, [&](const Vec& p) {
    const bool liver = (p - middle).cwiseQuotient(Vec(118, 108, 105)).norm() < 1.0;
    labels.push_back(liver ? structure::kParenchyma : structure::kBackground);
    return (p - middle).norm() < kHalf ? 60.0 : liver ? kLiver : -90.0;
  });
  LabelMap kept;
  kept.voxels = LabelVolume(grid, labels);
  kept.infos = {structure_info(structure::kParenchyma)};
  SegmentationOptions options;
  options.structures = {false, false, false, false, false, true};
  const auto told = [&](double diameter_mm) {
    Seeds seeds;
    seeds.lesions = {test::points_at(image, {middle})};
    if (diameter_mm > 0.0) seeds.lesion_diameters_mm = {diameter_mm};
    const SegmentationReport report = segment(image, seeds, options, RunContext(), &kept)->report;
    std::string all = std::to_string(report.lesion_ml.front()) + " ml";
    for (const std::string& note : report.notes) all += " " + note;
    return all;
  };
  const std::string clicked = told(0.0), drawn = told(2.0 * kHalf);
  QVERIFY2(clicked.find("lesion_1.goes_on") != std::string::npos, clicked.c_str());
  QVERIFY2(drawn.find("lesion_1.goes_on") == std::string::npos, drawn.c_str());
}

QTEST_GUILESS_MAIN(LesionsTest)
#include "lesions_test.moc"
