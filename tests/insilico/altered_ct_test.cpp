// SPDX-License-Identifier: GPL-3.0-or-later
// A CT altered in a known way: what is put into it is there, what is not stays as it was.
#include "glisson/insilico/altered_ct.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "glisson/core/error.h"
#include "glisson/volume/morphology.h"

using namespace glisson;
using namespace glisson::insilico;

namespace {

/// A liver without lesions.
const PathologyCt& whole() {
  static const PathologyCt kMade = [] {
    Pathology pathology = pathologies(3).front();
    pathology.spacing_mm = {3.0, 3.0, 4.0};
    pathology.lesions.clear();
    return make_pathology_ct(pathology, RunContext()).value();
  }();
  return kMade;
}

PathologyCt altered(const Alteration& alteration, std::uint64_t seed = 5) {
  return altered_ct(whole().ct, whole().truth, alteration, seed, RunContext()).value();
}

Alteration with_tumour(LesionKind::Place place, double radius_mm) {
  Alteration alteration;
  alteration.lesions = {{LesionKind::Look::hypodense, place, radius_mm}};
  return alteration;
}

/// Middle of a label's voxels in the truth, LPS millimetres.
Eigen::Vector3d centroid_of(const PathologyCt& made, Label wanted) {
  const VolumeGrid& grid = made.ct.grid;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i)
        if (made.truth.voxels.at({i, j, k}) == wanted) {
          sum += 1e3 * grid.p_in_ct(Eigen::Vector3d(i, j, k)).xyz;
          count += 1.0;
        }
  return sum / count;
}

struct Spread {
  double mean = 0.0, deviation = 0.0, count = 0.0;
};
Spread spread_of(const PathologyCt& made, Label wanted) {
  const std::vector<Label> labels = made.truth.voxels.dense();
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == wanted) {
      const double value = (*made.ct.voxels)[i];
      sum += value, squares += value * value, count += 1.0;
    }
  const double mean = sum / count;
  return {mean, std::sqrt(squares / count - mean * mean), count};
}

}  // namespace

class AlteredCtTest : public QObject {
  Q_OBJECT
 private slots:
  void TumourIsDarkerByTheContrastAndAsNoisy();
  void NothingElseChanges();
  void TumourAtTheRimStaysByTheOrgan();
  void ThickSlicesAreMeansAndNoiseIsAdded();
  void OtherSeedsPutItElsewhere();
  void ALiverWithoutPlaceIsRefused();
};

void AlteredCtTest::TumourIsDarkerByTheContrastAndAsNoisy() {
  const PathologyCt made = altered(with_tumour(LesionKind::Place::deep, 18.0));
  const Spread tumour = spread_of(made, structure::kFirstLesion),
               liver = spread_of(whole(), structure::kParenchyma);
  QVERIFY(std::abs(liver.mean - tumour.mean - 45.0) < 8.0);
  // The picture's own noise is kept; of the edge's blur a little is added.
  QVERIFY(tumour.deviation > 0.5 * liver.deviation && tumour.deviation < 2.0 * liver.deviation);
  const double ml = 1e-3 * tumour.count * made.ct.grid.voxel_volume_mm3();
  QVERIFY(std::abs(ml / (4e-3 / 3.0 * std::numbers::pi * std::pow(18.0, 3)) - 1.0) < 0.25);
}

void AlteredCtTest::NothingElseChanges() {
  const PathologyCt made = altered(with_tumour(LesionKind::Place::deep, 14.0));
  const std::vector<Label> before = whole().truth.voxels.dense(), after = made.truth.voxels.dense();
  Mask tumour(made.ct.grid.size, made.ct.grid.spacing_mm);
  for (std::size_t i = 0; i < after.size(); ++i) tumour.voxels[i] = after[i] == structure::kFirstLesion;
  const std::vector<float> away2 = squared_distance_mm2(tumour);
  for (std::size_t i = 0; i < after.size(); ++i) {
    QVERIFY(tumour.voxels[i] != 0 || before[i] == after[i]);
    if (away2[i] > 36.0F) QCOMPARE((*made.ct.voxels)[i], (*whole().ct.voxels)[i]);
  }
}

void AlteredCtTest::TumourAtTheRimStaysByTheOrgan() {
  const PathologyCt made = altered(with_tumour(LesionKind::Place::rim, 20.0));
  Mask liver(made.ct.grid.size, made.ct.grid.spacing_mm);
  liver.voxels = inside_liver(whole().truth);
  const std::vector<float> beyond2 = squared_distance_mm2(liver);
  for (auto& voxel : liver.voxels) voxel = voxel == 0 ? 1 : 0;
  const std::vector<float> depth2 = squared_distance_mm2(liver);
  const std::vector<Label> labels = made.truth.voxels.dense();
  long outside = 0, near = 0, all = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == structure::kFirstLesion) {
      ++all;
      outside += depth2[i] == 0.0F;
      near += depth2[i] < 25.0F;
      QVERIFY(beyond2[i] <= 9.0F + 1e-3F);
    }
  QVERIFY(near > 0 && outside < all / 4);
}

void AlteredCtTest::ThickSlicesAreMeansAndNoiseIsAdded() {
  Alteration thick;
  thick.slices_joined = 3;
  const PathologyCt made = altered(thick);
  const Eigen::Vector3i size = whole().ct.grid.size, at(size.x() / 2, size.y() / 2, 4);
  QCOMPARE(made.ct.grid.size.z(), size.z() / 3);
  double sum = 0.0;
  for (int n = 0; n < 3; ++n) sum += whole().ct.at({at.x(), at.y(), 12 + n});
  QVERIFY(std::abs(sum / 3.0 - made.ct.at(at)) <= 0.5);
  const double apart = (made.ct.grid.p_in_ct(at.cast<double>()).xyz -
                        whole().ct.grid.p_in_ct(Eigen::Vector3d(at.x(), at.y(), 13.0)).xyz)
                           .norm();
  QVERIFY(apart < 1e-9);
  Alteration noise;
  noise.noise_hu = 25.0;
  const PathologyCt noisy = altered(noise);
  double squares = 0.0;
  long count = 0;
  for (std::size_t i = 0; i < noisy.ct.voxels->size(); ++i)
    if ((*whole().ct.voxels)[i] > -900) {
      squares += std::pow((*noisy.ct.voxels)[i] - (*whole().ct.voxels)[i], 2);
      ++count;
    }
  QVERIFY(std::abs(std::sqrt(squares / static_cast<double>(count)) - 25.0) < 0.5);
}

void AlteredCtTest::OtherSeedsPutItElsewhere() {
  const Alteration alteration = with_tumour(LesionKind::Place::beside_cava, 16.0);
  const PathologyCt one = altered(alteration, 1), again = altered(alteration, 1),
                    other = altered(alteration, 2);
  QCOMPARE(*one.ct.voxels, *again.ct.voxels);
  QVERIFY(*one.ct.voxels != *other.ct.voxels);
  std::vector<Eigen::Vector3d> centroids;
  for (const PathologyCt& made : {one, other, altered(alteration, 3), altered(alteration, 4)})
    centroids.push_back(centroid_of(made, structure::kFirstLesion));
  double farthest = 0.0;
  for (const Eigen::Vector3d& a : centroids)
    for (const Eigen::Vector3d& b : centroids) farthest = std::max(farthest, (a - b).norm());
  QVERIFY2(farthest > 10.0, qPrintable(QString::number(farthest)));
}

void AlteredCtTest::ALiverWithoutPlaceIsRefused() {
  QVERIFY_THROWS_EXCEPTION(InputError, altered(with_tumour(LesionKind::Place::beside_cava, 400.0)));
  LabelMap empty{LabelVolume(whole().ct.grid), {}};
  QVERIFY_THROWS_EXCEPTION(InputError, altered_ct(whole().ct, empty, {}, 1, RunContext()));
}

QTEST_APPLESS_MAIN(AlteredCtTest)
#include "altered_ct_test.moc"
