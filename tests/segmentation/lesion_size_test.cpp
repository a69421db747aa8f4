// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/lesion_size.h"

#include <QTest>
#include <random>

using namespace glisson;
using namespace glisson::segmentation;

namespace {

Mask ellipsoid(const Eigen::Vector3d& half_mm, const Eigen::Matrix3d& turn, const Eigen::Vector3d& spacing) {
  const double reach = half_mm.maxCoeff() + 3.0;
  const Eigen::Vector3i size = (2.0 * reach * spacing.cwiseInverse()).array().ceil().matrix().cast<int>();
  Mask mask(size, spacing);
  const Eigen::Vector3d middle = 0.5 * size.cast<double>().cwiseProduct(spacing);
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i) {
        const Eigen::Vector3d p =
            turn.transpose() * (Eigen::Vector3d(i, j, k).cwiseProduct(spacing) - middle);
        mask.voxels[mask.offset(i, j, k)] = p.cwiseQuotient(half_mm).norm() <= 1.0 ? 1 : 0;
      }
  return mask;
}

double by_trying_all(const Mask& mask) {
  std::vector<Eigen::Vector3d> places;
  for (int k = 0; k < mask.size.z(); ++k)
    for (int j = 0; j < mask.size.y(); ++j)
      for (int i = 0; i < mask.size.x(); ++i)
        if (mask.voxels[mask.offset(i, j, k)] != 0)
          places.push_back(Eigen::Vector3d(i, j, k).cwiseProduct(mask.spacing_mm));
  double longest2 = 0.0;
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = a + 1; b < places.size(); ++b)
      longest2 = std::max(longest2, (places[a] - places[b]).squaredNorm());
  return std::sqrt(longest2);
}

}  // namespace

class LesionSizeTest : public QObject {
  Q_OBJECT
 private slots:
  void EllipsoidHasItsLongAxis();
  void SameAsTryingAllPairs();
  void LabelIsMeasuredInItsVolume();
  void NothingHasNoDiameter();
};

void LesionSizeTest::EllipsoidHasItsLongAxis() {
  const Eigen::Vector3d spacing(0.6, 0.7, 1.5);
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 12; ++trial) {
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond{normal(random), normal(random), normal(random), normal(random)}
            .normalized()
            .matrix();
    const Eigen::Vector3d half(9.0 + trial, 14.0 + trial, 6.0);
    const Mask mask = ellipsoid(half, turn, spacing);
    const LongestDiameter found = longest_diameter(mask);
    // Centres lie inside, by less than a voxel's diagonal at each end.
    const double truth = 2.0 * half.y();
    QVERIFY2(found.mm <= truth + 1e-9 && found.mm > truth - 1.5,
             qPrintable(QString::number(found.mm - truth)));
    QCOMPARE(longest_diameter_mm(mask), found.mm);
    const Eigen::Vector3d along = (found.to - found.from).cast<double>().cwiseProduct(spacing);
    QVERIFY(std::abs(along.norm() - found.mm) < 1e-9);
    QVERIFY(std::abs(along.normalized().dot(turn.col(1))) > 0.9);
    QVERIFY(mask.voxels[mask.offset(found.from.x(), found.from.y(), found.from.z())] != 0);
    QVERIFY(mask.voxels[mask.offset(found.to.x(), found.to.y(), found.to.z())] != 0);
  }
}

void LesionSizeTest::SameAsTryingAllPairs() {
  std::mt19937 random(7);
  for (int trial = 0; trial < 60; ++trial) {
    Mask mask({9, 8, 7}, {0.7, 0.9, 1.6});
    const unsigned one_in = 2 + static_cast<unsigned>(trial % 20);
    for (auto& v : mask.voxels) v = random() % one_in == 0 ? 1 : 0;
    QCOMPARE(longest_diameter_mm(mask), by_trying_all(mask));
  }
  const Mask ball = ellipsoid({8, 8, 8}, Eigen::Matrix3d::Identity(), {1, 1, 1});
  QCOMPARE(longest_diameter_mm(ball), by_trying_all(ball));
}

void LesionSizeTest::LabelIsMeasuredInItsVolume() {
  VolumeGrid grid;
  grid.size = {50, 40, 60};
  grid.spacing_mm = {0.5, 0.5, 2.0};
  LabelVolume labels(grid);
  labels.set({40, 3, 50}, structure::kFirstLesion);
  labels.set({34, 3, 46}, structure::kFirstLesion);
  labels.set({0, 0, 0}, structure::kParenchyma);
  const LongestDiameter found = longest_diameter(labels, structure::kFirstLesion);
  QCOMPARE(found.mm, std::sqrt(9.0 + 64.0));
  QCOMPARE(found.from, Eigen::Vector3i(34, 3, 46));
  QCOMPARE(found.to, Eigen::Vector3i(40, 3, 50));
}

void LesionSizeTest::NothingHasNoDiameter() {
  Mask mask({4, 4, 4}, {1, 1, 1});
  QCOMPARE(longest_diameter_mm(mask), 0.0);
  mask.voxels[21] = 1;
  QCOMPARE(longest_diameter_mm(mask), 0.0);
  VolumeGrid grid;
  grid.size = {4, 4, 4};
  QCOMPARE(longest_diameter(LabelVolume(grid), 16).mm, 0.0);
}

QTEST_APPLESS_MAIN(LesionSizeTest)
#include "lesion_size_test.moc"
