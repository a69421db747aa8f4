// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the list of labels, and the numbers of lesions that are seeded.
#include "glisson/ui/segmentation/label_rows.h"

#include <QTest>
#include <set>

#include "glisson/ui/segmentation/seed_book.h"

namespace glisson {

class LabelRowsTest : public QObject {
  Q_OBJECT
 private slots:
  void RowsShowUsualLabelsFirstAndAFreeLesion();
  void LesionsThatAreSeededKeepTheirNumbers();
  void ADiameterGoesWithAnySeedOfItsLesion();
};

void LabelRowsTest::RowsShowUsualLabelsFirstAndAFreeLesion() {
  const auto labels_of = [](const std::vector<ui::LabelRow>& rows) {
    std::vector<Label> labels;
    for (const ui::LabelRow& row : rows) labels.push_back(row.label);
    return labels;
  };
  QVERIFY((labels_of(ui::label_rows(nullptr, nullptr)) == std::vector<Label>{1, 2, 3, 4, 6, 16}));
  // And what is worked on, though nothing of it is there.
  QVERIFY((labels_of(ui::label_rows(nullptr, nullptr, structure::kFirstOther)) ==
           std::vector<Label>{1, 2, 3, 4, 6, 7, 16}));
  QVERIFY((labels_of(ui::label_rows(nullptr, nullptr, structure::kFirstLesion)) ==
           std::vector<Label>{1, 2, 3, 4, 6, 16}));
  Image image;
  image.grid.size = {8, 8, 8};
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(512, std::int16_t{90});
  LabelMap map;
  map.voxels = LabelVolume(image.grid);
  map.voxels.set({1, 1, 1}, structure::kFirstLesion);
  map.voxels.set({2, 1, 1}, structure::kPortalVein);
  map.voxels.set({5, 5, 5}, structure::kFirstLesion + 2);
  const segmentation::LabelStatistics statistics(map, &image);
  const Review review = {{structure::kPortalVein, ReviewState::approved}};
  const auto rows = ui::label_rows(&statistics, &review);
  QVERIFY((labels_of(rows) == std::vector<Label>{1, 2, 3, 4, 6, 16, 17, 18}));  // 17 is free
  QCOMPARE(rows[1].review, ReviewState::approved);
  QCOMPARE(rows[1].figures.voxels, 1L);
  QCOMPARE(rows[1].figures.mean_hu, 90.0);
  QCOMPARE(rows[6].figures.voxels, 0L);
}

void LabelRowsTest::LesionsThatAreSeededKeepTheirNumbers() {
  VolumeGrid grid;
  grid.size = {8, 8, 8};
  LabelMap map{LabelVolume(grid), {}};
  map.voxels.set({1, 1, 1}, structure::kFirstLesion);
  const segmentation::LabelStatistics painted(map, nullptr);
  segmentation::Seeds seeds;
  const auto offered = [&](const segmentation::LabelStatistics* statistics) {
    return ui::lesions_to_seed(seeds, statistics);
  };
  QVERIFY(offered(nullptr) == std::set<Label>{16});
  QVERIFY(offered(&painted) == std::set<Label>{17});  // the first one was painted by a hand
  ui::add_seed(seeds, 17, {0.0, 0.0, 0.01});
  QCOMPARE(seeds.lesions.size(), std::size_t{2});
  QCOMPARE(seeds.lesions[0].rows(), Eigen::Index{0});
  QVERIFY((offered(&painted) == std::set<Label>{17, 18}));
  QVERIFY((offered(nullptr) == std::set<Label>{16, 17}));
  ui::add_seed(seeds, 16, {0.0, 0.01, 0.0});
  ui::add_seed(seeds, 18, {0.01, 0.0, 0.0});
  ui::remove_seed(seeds, {16, 0});
  std::vector<Label> listed;
  for (const ui::SeedEntry& entry : ui::list_seeds(seeds)) listed.push_back(entry.structure);
  QVERIFY((listed == std::vector<Label>{17, 18}));
  QCOMPARE(seeds.lesions[1](0, 2), 0.01);
  ui::remove_seed(seeds, {17, 0});
  QCOMPARE(seeds.lesions.size(), std::size_t{3});
  ui::remove_seed(seeds, {18, 0});  // nothing behind it keeps a number
  QVERIFY(seeds.lesions.empty());
}

/// Which of the seeds it was drawn at is not known: the lesion is found by its edge instead.
void LabelRowsTest::ADiameterGoesWithAnySeedOfItsLesion() {
  segmentation::Seeds seeds;
  ui::add_seed(seeds, 16, {0.0, 0.0, 0.01});
  ui::add_seed(seeds, 16, {0.0, 0.01, 0.0});
  ui::add_seed(seeds, 17, {0.02, 0.0, 0.0});
  ui::set_diameter(seeds, 16, 40.0);
  ui::set_diameter(seeds, 17, 12.0);
  ui::remove_seed(seeds, {16, 1});
  QCOMPARE(seeds.lesions[0].rows(), Eigen::Index{1});
  QCOMPARE(seeds.lesion_diameter_mm(0), 0.0);
  QCOMPARE(seeds.lesion_diameter_mm(1), 12.0);
  ui::remove_seed(seeds, {17, 0});
  QCOMPARE(seeds.lesion_diameter_mm(1), 0.0);
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::LabelRowsTest)
#include "label_rows_test.moc"
