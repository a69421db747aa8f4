// SPDX-License-Identifier: GPL-3.0-or-later
// CTs of ill livers and a layperson's clicks: what is asked for is in the picture, where the truth says.
#include "glisson/insilico/pathology.h"

#include <QTest>
#include <cmath>

#include "glisson/insilico/layperson.h"
#include "glisson/segmentation/lesion_size.h"

using namespace glisson;
using namespace glisson::insilico;

namespace {

Pathology coarse(Pathology pathology) {
  pathology.spacing_mm = {3.0, 3.0, 4.0};
  return pathology;
}

Pathology named(const std::string& name) {
  for (const Pathology& one : pathologies(3))
    if (one.name == name) return coarse(one);
  return {};
}

PathologyCt made(const Pathology& pathology) { return make_pathology_ct(pathology, RunContext()).value(); }

double mean_of(const PathologyCt& made, Label wanted) {
  const std::vector<Label> labels = made.truth.voxels.dense();
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == wanted) sum += (*made.ct.voxels)[i], count += 1.0;
  return count > 0.0 ? sum / count : std::nan("");
}

double ml_of(const PathologyCt& made, Label wanted) {
  return 1e-3 * static_cast<double>(made.truth.voxels.histogram()[wanted]) * made.ct.grid.voxel_volume_mm3();
}

Eigen::Vector3i voxel(const VolumeGrid& grid, const Points& points, Eigen::Index n) {
  return grid.index_of(Point<CtFrame>(Eigen::Vector3d(points.row(n).transpose())))
      .array()
      .round()
      .matrix()
      .cast<int>();
}

}  // namespace

class PathologyTest : public QObject {
  Q_OBJECT
 private slots:
  void SamePathologyGivesTheSameBits();
  void LesionsLookAndWeighAsTold();
  void FattyLiverIsDarkerThanItsVessels();
  void ThickSlicesAreMeans();
  void LaypersonClicksWhereTheEyeSees();
  void LaypersonCorrectsWhatIsMostDeeplyWrong();
  void TumoursOfOneLabelAreToldApart();
};

void PathologyTest::SamePathologyGivesTheSameBits() {
  const PathologyCt one = made(named("metal")), two = made(named("metal"));
  QVERIFY(*one.ct.voxels == *two.ct.voxels);
  QVERIFY(one.truth.voxels.dense() == two.truth.voxels.dense());
  QVERIFY(pathologies(3).size() >= 12);
  QVERIFY(pathologies(3).front().shape_seed != pathologies(4).front().shape_seed);
}

void PathologyTest::LesionsLookAndWeighAsTold() {
  const PathologyCt dark = made(named("hypodense, rim"));
  QVERIFY(mean_of(dark, structure::kFirstLesion) < mean_of(dark, structure::kParenchyma) - 25.0);
  // A ball of 28 mm; a part of it may be cut off by the organ's border.
  const double whole = 4.18879e-3 * std::pow(28.0, 3);
  QVERIFY(ml_of(dark, structure::kFirstLesion) > 0.6 * whole);
  QVERIFY(ml_of(dark, structure::kFirstLesion) < 1.15 * whole);
  const PathologyCt cyst = made(named("cysts"));
  QVERIFY(std::abs(mean_of(cyst, structure::kFirstLesion + 1)) < 40.0);
}

void PathologyTest::FattyLiverIsDarkerThanItsVessels() {
  const PathologyCt fatty = made(named("fatty"));
  QVERIFY(mean_of(fatty, structure::kParenchyma) < 60.0);
  QVERIFY(mean_of(fatty, structure::kVenaCava) > mean_of(fatty, structure::kParenchyma) + 40.0);
  const PathologyCt plain = made(named("unenhanced"));
  QVERIFY(mean_of(plain, structure::kVenaCava) < mean_of(plain, structure::kParenchyma));
}

void PathologyTest::ThickSlicesAreMeans() {
  Pathology thin = named("fatty");
  thin.noise_hu = 0.0;
  thin.spacing_mm = {3.0, 3.0, 2.0};
  Pathology thick = thin;
  thick.spacing_mm.z() = 4.0;
  const PathologyCt a = made(thin), b = made(thick);
  const Eigen::Vector3i at(60, 50, 30);
  const auto value = [](const PathologyCt& of, const Eigen::Vector3i& v) {
    return static_cast<double>((*of.ct.voxels)[static_cast<std::size_t>(of.ct.grid.offset(v))]);
  };
  const double mean =
      0.5 * (value(a, {at.x(), at.y(), 2 * at.z()}) + value(a, {at.x(), at.y(), 2 * at.z() + 1}));
  QVERIFY(std::abs(value(b, at) - mean) <= 1.0);
}

void PathologyTest::LaypersonClicksWhereTheEyeSees() {
  const PathologyCt patient = made(named("hypodense, rim"));
  const std::vector<std::uint8_t> liver = inside_liver(patient.truth);
  LaypersonOptions options;
  options.least_lesion_ml = 1.0;
  options.seed = 5;
  const auto seeds = click_as_layperson(patient.ct, patient.truth, options);
  QCOMPARE(seeds.liver.rows(), Eigen::Index(5));
  QCOMPARE(seeds.background.rows(), Eigen::Index(5));
  QCOMPARE(seeds.lesions.size(), std::size_t(1));
  const VolumeGrid& grid = patient.ct.grid;
  const auto is_liver = [&](const Points& points, Eigen::Index n) {
    return liver[static_cast<std::size_t>(grid.offset(voxel(grid, points, n)))] != 0;
  };
  for (Eigen::Index n = 0; n < 5; ++n) {
    QVERIFY(is_liver(seeds.liver, n));
    QVERIFY(!is_liver(seeds.background, n));
  }
  QCOMPARE(patient.truth.voxels.at(voxel(grid, seeds.lesions[0], 0)), structure::kFirstLesion);
  options.seed = 6;
  QVERIFY(!click_as_layperson(patient.ct, patient.truth, options).liver.isApprox(seeds.liver));
  // Drawn across: in the lesion, as wide as it is in a slice, but for the hand's slips.
  options.draws_lesions = true;
  const auto drawn = click_as_layperson(patient.ct, patient.truth, options);
  QCOMPARE(patient.truth.voxels.at(voxel(grid, drawn.lesions.at(0), 0)), structure::kFirstLesion);
  const double longest = segmentation::longest_diameter(patient.truth.voxels, structure::kFirstLesion).mm;
  QVERIFY(drawn.lesion_diameter_mm(0) > 0.5 * longest && drawn.lesion_diameter_mm(0) < 1.3 * longest);
  QCOMPARE(seeds.lesion_diameter_mm(0), 0.0);
}

void PathologyTest::LaypersonCorrectsWhatIsMostDeeplyWrong() {
  const PathologyCt patient = made(named("hypodense, rim"));
  const VolumeGrid& grid = patient.truth.voxels.grid();
  QVERIFY(!correct_as_layperson(patient.truth, patient.truth, 1));
  // The lesion is missing, and a smaller cube beside the liver is too much.
  LabelMap labels = patient.truth;
  std::vector<Label> dense = labels.voxels.dense();
  for (Label& label : dense)
    if (label == structure::kFirstLesion) label = structure::kBackground;
  labels.voxels = LabelVolume(grid, dense);
  const auto add_cube = [](LabelMap& to) {
    for (int k = 2; k < 6; ++k)
      for (int j = 2; j < 6; ++j)
        for (int i = 2; i < 6; ++i) to.voxels.set({i, j, k}, structure::kParenchyma);
  };
  add_cube(labels);
  const auto voxel_of = [&](const segmentation::Click& click) {
    return Eigen::Vector3i(grid.index_of(click.p_in_ct).array().round().matrix().cast<int>());
  };
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    const auto click = correct_as_layperson(patient.truth, labels, seed);
    QVERIFY(click && click->is_liver);
    QCOMPARE(patient.truth.voxels.at(voxel_of(*click)), structure::kFirstLesion);
    QVERIFY(*click == *correct_as_layperson(patient.truth, labels, seed));
  }
  // With the lesion there, the cube is what is left.
  LabelMap cube = patient.truth;
  add_cube(cube);
  const auto click = correct_as_layperson(patient.truth, cube, 1);
  QVERIFY(click && !click->is_liver);
}

void PathologyTest::TumoursOfOneLabelAreToldApart() {
  VolumeGrid grid;
  grid.size = {30, 12, 12};
  grid.spacing_mm = {1.0, 1.0, 1.0};
  LabelMap truth;
  truth.voxels = LabelVolume(grid);
  const auto cube = [&](int from, int side) {
    for (int k = 0; k < side; ++k)
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) truth.voxels.set({from + i, j, k}, structure::kFirstLesion);
  };
  cube(0, 2);  // two that are too small for a click
  cube(4, 6);
  cube(12, 8);
  cube(25, 2);
  split_lesions(truth, 0.1);
  const auto at = [&](int i) { return truth.voxels.at({i, 0, 0}) - structure::kFirstLesion; };
  QCOMPARE(at(12), 0);
  QCOMPARE(at(4), 1);
  QCOMPARE(at(0), 2);
  QCOMPARE(at(25), 2);
  QCOMPARE(truth.voxels.at({23, 0, 0}), structure::kBackground);
}

QTEST_APPLESS_MAIN(PathologyTest)
#include "pathology_test.moc"
