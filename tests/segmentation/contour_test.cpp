// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

#include "field.h"
#include "level_set.h"

using namespace glisson;
using namespace glisson::segmentation;

namespace {

Field noise(const Eigen::Vector3i& size, const Eigen::Vector3d& spacing_mm) {
  Field field;
  field.size = size;
  field.spacing_mm = spacing_mm;
  field = field.filled(0.0F);
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  for (float& value : field.values) value = normal(random);
  return field;
}

/// The Gaussian's sum over the axes at a voxel, in one go; the edge's sample stands for those beyond it.
double direct_sum(const Field& field, const Eigen::Vector3i& at, double sigma_mm) {
  double sum = 0.0, weights = 0.0;
  const Eigen::Vector3i reach = (3.0 * sigma_mm * field.spacing_mm.cwiseInverse()).array().ceil().cast<int>();
  for (int k = -reach.z(); k <= reach.z(); ++k)
    for (int j = -reach.y(); j <= reach.y(); ++j)
      for (int i = -reach.x(); i <= reach.x(); ++i) {
        const Eigen::Vector3i step(i, j, k);
        const double r = step.cast<double>().cwiseProduct(field.spacing_mm).norm();
        const double w = std::exp(-0.5 * r * r / (sigma_mm * sigma_mm));
        const Eigen::Vector3i from =
            (at + step).cwiseMax(0).cwiseMin(field.size - Eigen::Vector3i::Ones().eval());
        sum += w * field.values[field.offset(from)];
        weights += w;
      }
  return sum / weights;
}

Field sphere(const Field& grid, const Eigen::Vector3d& middle, double radius) {
  Field phi = grid;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i)
        phi.values[grid.offset(i, j, k)] = static_cast<float>(
            (Eigen::Vector3d(i, j, k) - middle).cwiseProduct(grid.spacing_mm).norm() - radius);
  return phi;
}

ContourForces moving_outwards(const Field& grid, float by) {
  ContourForces forces;
  forces.curvature_mm = 1e-3;
  forces.attraction_mm = 0.0;
  forces.edge = grid.filled(1.0F);
  forces.region = grid.filled(by);
  return forces;
}

double radius_of(const Field& phi) {
  const auto inside = std::count_if(phi.values.begin(), phi.values.end(), [](float v) { return v < 0.0F; });
  return std::cbrt(0.75 / std::numbers::pi * static_cast<double>(inside) * phi.spacing_mm.prod());
}

}  // namespace

class ContourTest : public QObject {
  Q_OBJECT
 private slots:
  void SmoothingIsTheDirectSum();
  void AFrontThatMovesStaysADistance_data();
  void AFrontThatMovesStaysADistance();
  void AFrontComesBackFromTheEdge();
};

void ContourTest::SmoothingIsTheDirectSum() {
  // Large enough for two threads, with a step of its own along each axis.
  const Field before = noise({61, 50, 41}, {0.8, 1.0, 1.7});
  Field after = before;
  smooth(after, 1.3);
  for (const Eigen::Vector3i& at :
       {Eigen::Vector3i(0, 0, 0), Eigen::Vector3i(60, 49, 40), Eigen::Vector3i(1, 25, 39),
        Eigen::Vector3i(30, 3, 20), Eigen::Vector3i(31, 24, 19), Eigen::Vector3i(58, 48, 0)})
    QVERIFY(std::abs(after.values[after.offset(at)] - direct_sum(before, at, 1.3)) < 1e-5);
}

void ContourTest::AFrontThatMovesStaysADistance_data() {
  QTest::addColumn<float>("by");
  QTest::newRow("outwards") << 1.0F;
  QTest::newRow("inwards") << -1.0F;
}

void ContourTest::AFrontThatMovesStaysADistance() {
  QFETCH(float, by);
  const Field grid = noise({72, 72, 72}, {1.0, 1.0, 1.0}).filled(0.0F);
  const Eigen::Vector3d middle(35.3, 34.6, 35.1);
  Field phi = sphere(grid, middle, 18.0);
  // Ten rebuilds, in which the front goes farther than its band is wide.
  QVERIFY(evolve(phi, moving_outwards(grid, by), 36, RunContext()));
  const double radius = radius_of(phi);
  QVERIFY(by * (radius - 18.0) > 7.0);
  const Field truth = sphere(grid, middle, radius);
  for (std::size_t at = 0; at < phi.values.size(); ++at) {
    const float wanted = std::clamp(truth.values[at], -3.5F, 3.5F);
    QVERIFY2(std::abs(phi.values[at] - wanted) < 0.6F,
             qPrintable(QStringLiteral("%1: %2, not %3").arg(at).arg(phi.values[at]).arg(wanted)));
  }
}

void ContourTest::AFrontComesBackFromTheEdge() {
  // It grows into the volume's edge and is then drawn in until nothing is left: no voxel is forgotten.
  const Field grid = noise({40, 36, 44}, {1.0, 1.0, 1.0}).filled(0.0F);
  Field phi = sphere(grid, {12.0, 17.0, 20.0}, 9.0);
  QVERIFY(evolve(phi, moving_outwards(grid, 1.0F), 40, RunContext()));
  QVERIFY(phi.values[grid.offset(1, 17, 20)] < 0.0F);
  ContourForces inwards = moving_outwards(grid, -1.0F);
  QVERIFY(evolve(phi, inwards, 200, RunContext()));
  for (int k = 1; k + 1 < grid.size.z(); ++k)
    for (int j = 1; j + 1 < grid.size.y(); ++j)
      for (int i = 1; i + 1 < grid.size.x(); ++i) QVERIFY(phi.values[grid.offset(i, j, k)] > 0.0F);
}

QTEST_APPLESS_MAIN(ContourTest)
#include "contour_test.moc"
