// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/statistics.h"

#include <QTest>

#include <random>

#include "glisson/core/error.h"
#include "glisson/segmentation/lesion_size.h"

using namespace glisson;
using namespace glisson::segmentation;

namespace {

Image noise(const Eigen::Vector3i& size, std::mt19937_64& random) {
  Image image;
  image.grid.size = size;
  image.grid.spacing_mm = {0.5, 0.6, 2.0};
  std::vector<std::int16_t> voxels(static_cast<std::size_t>(image.grid.voxel_count()));
  for (std::int16_t& voxel : voxels)
    voxel = static_cast<std::int16_t>(static_cast<int>(random() % 2000) - 1000);
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
  return image;
}

/// One label, voxel by voxel.
LabelFigures counted(const LabelMap& labels, const Image& image, Label label) {
  LabelFigures figures;
  double sum = 0.0, squares = 0.0;
  const std::vector<Label> dense = labels.voxels.dense();
  for (std::size_t i = 0; i < dense.size(); ++i) {
    if (dense[i] != label) continue;
    ++figures.voxels;
    sum += (*image.voxels)[i];
  }
  figures.mean_hu = sum / static_cast<double>(figures.voxels);
  for (std::size_t i = 0; i < dense.size(); ++i)
    if (dense[i] == label) squares += std::pow((*image.voxels)[i] - figures.mean_hu, 2);
  figures.sd_hu = std::sqrt(squares / static_cast<double>(figures.voxels));
  figures.ml = 0.5 * 0.6 * 2.0 * 1e-3 * static_cast<double>(figures.voxels);
  return figures;
}

}  // namespace

class StatisticsTest : public QObject {
  Q_OBJECT
 private slots:
  void AgreesWithCountingVoxelByVoxelAfterEveryEdit();
  void OnlyBricksThatChangedAreCountedAgain();
  void AnotherImageIsMeasuredAnew();
  void WithoutAnImageVolumesAreKnown();
  void LesionDiametersFollowEveryEdit();
};

void StatisticsTest::AgreesWithCountingVoxelByVoxelAfterEveryEdit() {
  std::mt19937_64 random(11);
  const Image image = noise({70, 45, 40}, random);
  LabelMap labels;
  labels.voxels = LabelVolume(image.grid);
  LabelStatistics statistics(labels, &image);
  QVERIFY(statistics.figures().empty());
  for (int edit = 0; edit < 40; ++edit) {
    const auto label = static_cast<Label>(random() % 4);
    const Eigen::Vector3i low{static_cast<int>(random() % 60), static_cast<int>(random() % 35),
                              static_cast<int>(random() % 30)};
    for (int k = 0; k < 10; ++k)
      for (int j = 0; j < 10; ++j)
        for (int i = 0; i < 10; ++i) labels.voxels.set(low + Eigen::Vector3i(i, j, k), label);
    statistics = LabelStatistics(labels, &image, &statistics);
    const std::vector<long> histogram = labels.voxels.histogram();
    for (Label present = 1; present < 4; ++present) {
      const bool there = present < histogram.size() && histogram[present] > 0;
      QCOMPARE(statistics.figures().contains(present), there);
      if (!there) continue;
      const LabelFigures wanted = counted(labels, image, present);
      const LabelFigures& got = statistics.figures().at(present);
      QCOMPARE(got.voxels, wanted.voxels);
      QVERIFY(std::abs(got.ml - wanted.ml) < 1e-9);
      QVERIFY(std::abs(got.mean_hu - wanted.mean_hu) < 1e-9 * 1000);
      QVERIFY(std::abs(got.sd_hu - wanted.sd_hu) < 1e-6 * 1000);
    }
  }
}

void StatisticsTest::OnlyBricksThatChangedAreCountedAgain() {
  std::mt19937_64 random(12);
  const Image image = noise({96, 96, 96}, random);
  LabelMap labels;
  labels.voxels =
      LabelVolume(image.grid, std::vector<Label>(static_cast<std::size_t>(image.grid.voxel_count()), 1));
  const LabelStatistics all(labels, &image);
  QCOMPARE(all.bricks_counted(), 27);
  labels.voxels.set({40, 40, 40}, 2);
  const LabelStatistics then(labels, &image, &all);
  QCOMPARE(then.bricks_counted(), 1);
  QCOMPARE(then.figures().at(2).voxels, 1L);
}

void StatisticsTest::AnotherImageIsMeasuredAnew() {
  std::mt19937_64 random(13);
  const Image first = noise({40, 40, 40}, random), second = noise({40, 40, 40}, random);
  LabelMap labels;
  labels.voxels = LabelVolume(first.grid);
  labels.voxels.set({3, 3, 3}, 1);
  const LabelStatistics of_first(labels, &first);
  const LabelStatistics of_second(labels, &second, &of_first);
  QCOMPARE(of_second.figures().at(1).mean_hu, static_cast<double>(second.at({3, 3, 3})));
}

void StatisticsTest::WithoutAnImageVolumesAreKnown() {
  LabelMap labels;
  VolumeGrid grid;
  grid.size = {10, 10, 10};
  labels.voxels = LabelVolume(grid);
  labels.voxels.set({3, 3, 3}, 1);
  const LabelStatistics statistics(labels, nullptr);
  QCOMPARE(statistics.figures().at(1).ml, 1e-3);
}

void StatisticsTest::LesionDiametersFollowEveryEdit() {
  std::mt19937_64 random(5);
  VolumeGrid grid;
  grid.size = {70, 45, 40};
  grid.spacing_mm = {0.5, 0.6, 2.0};
  LabelMap labels;
  labels.voxels = LabelVolume(grid);
  LabelStatistics statistics(labels, nullptr);
  const std::array<Label, 4> codes = {0, structure::kFirstLesion, structure::kFirstLesion + 1,
                                      structure::kParenchyma};
  for (int edit = 0; edit < 40; ++edit) {
    const Label label = codes[random() % 4];
    const Eigen::Vector3i low{static_cast<int>(random() % 66), static_cast<int>(random() % 41),
                              static_cast<int>(random() % 36)};
    for (int n = 0; n < 64; ++n) labels.voxels.set(low + Eigen::Vector3i(n % 4, n / 4 % 4, n / 16), label);
    statistics = LabelStatistics(labels, nullptr, &statistics);
    for (const auto& [code, figures] : statistics.figures()) {
      const double wanted = is_lesion(code) ? longest_diameter(labels.voxels, code).mm : 0.0;
      QCOMPARE(figures.longest_diameter_mm, wanted);
    }
  }
  QVERIFY(statistics.figures().at(structure::kFirstLesion).longest_diameter_mm > 10.0);
}

QTEST_APPLESS_MAIN(StatisticsTest)
#include "statistics_test.moc"
