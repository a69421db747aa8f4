// SPDX-License-Identifier: GPL-3.0-or-later
// What one click makes of a lesion, on phantoms whose truth is a formula.
#include <QtTest>

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
    const bool vessel = std::hypot(p.x() - 60.0, p.y() - 54.0 + 0.9 * kRadius + 3.0) < 4.0;
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

}  // namespace

class LesionsTest : public QObject {
  Q_OBJECT
 private slots:
  void OneClickAnywhereFindsIt_data();
  void OneClickAnywhereFindsIt();
  void ABlurredEdgeIsNotTheLesions();
  void WhatIsNoLesionIsNotFound();
  void AFaintRimIsFoundOrSaid();
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

void LesionsTest::WhatIsNoLesionIsNotFound() {
  const Phantom none = phantom([](const Vec&, double) { return kLiver; });
  const Grown one = grown(none, Vec(3, 0, 2));
  QCOMPARE(one.ml, 0.0);
  QVERIFY(one.says("lesion_1.not_found"));
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
  QVERIFY_EXCEPTION_THROWN(grown(made, Vec::Zero(), 0.026), InputError);  // metres, not millimetres
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
