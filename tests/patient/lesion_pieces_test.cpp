// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/lesion_pieces.h"

#include <QTest>

using namespace glisson;

namespace {

constexpr Label kLesion = structure::kFirstLesion + 2;

LabelVolume empty(double slice_mm) {
  VolumeGrid grid;
  grid.size = {80, 40, 40};
  grid.spacing_mm = {1.0, 1.0, slice_mm};
  return LabelVolume(grid);
}

void put_ball(LabelVolume& labels, const Eigen::Vector3i& middle, double radius, Label label) {
  const int reach = static_cast<int>(radius);
  for (int k = -reach; k <= reach; ++k)
    for (int j = -reach; j <= reach; ++j)
      for (int i = -reach; i <= reach; ++i)
        if (Eigen::Vector3d(i, j, k).norm() <= radius) labels.set(middle + Eigen::Vector3i(i, j, k), label);
}

}  // namespace

class LesionPiecesTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatLiesApartIsAPiece();
  void AnEmptySliceDoesNotPart();
  void EachPieceBecomesALesion();
  void WhereNoLabelIsFreeTheSmallestStay();
};

void LesionPiecesTest::WhatLiesApartIsAPiece() {
  LabelVolume labels = empty(1.0);
  QVERIFY(lesion_pieces(labels, kLesion).empty());
  put_ball(labels, {5, 5, 5}, 5.0, kLesion);
  QCOMPARE(lesion_pieces(labels, kLesion).size(), std::size_t{1});
  put_ball(labels, {18, 5, 5}, 4.0, kLesion);  // from 10 to 14: three empty voxels
  QCOMPARE(lesion_pieces(labels, kLesion).size(), std::size_t{1});
  put_ball(labels, {75, 34, 34}, 3.0, kLesion);  // beyond a border of bricks
  const std::vector<long> sizes = lesion_pieces(labels, kLesion);
  QCOMPARE(sizes.size(), std::size_t{2});
  QCOMPARE(sizes[0] + sizes[1], labels.histogram()[kLesion]);
  QCOMPARE(sizes[1], 123L);         // the points of whole numbers within 3 of one of them
  labels.set({28, 5, 5}, kLesion);  // 6 mm from the second
  QCOMPARE(lesion_pieces(labels, kLesion).size(), std::size_t{3});
  labels.set({25, 5, 5}, kLesion);  // between the two
  QCOMPARE(lesion_pieces(labels, kLesion).size(), std::size_t{2});
}

void LesionPiecesTest::AnEmptySliceDoesNotPart() {
  LabelVolume labels = empty(5.0);
  for (const int k : {0, 1, 3, 6}) labels.set({10, 10, k}, kLesion);
  QCOMPARE(lesion_pieces(labels, kLesion).size(), std::size_t{1});
  labels.set({10, 10, 10}, kLesion);  // three are empty
  QCOMPARE(lesion_pieces(labels, kLesion).size(), std::size_t{2});
}

void LesionPiecesTest::EachPieceBecomesALesion() {
  LabelMap map{empty(1.0), {{kLesion, "all tumours", "a~terminology", {1, 0, 0}}}};
  put_ball(map.voxels, {5, 5, 5}, 3.0, kLesion);
  put_ball(map.voxels, {40, 20, 20}, 5.0, kLesion);
  put_ball(map.voxels, {70, 20, 20}, 4.0, kLesion);
  put_ball(map.voxels, {20, 30, 30}, 4.0, structure::kFirstLesion);  // whole
  map.voxels.set({60, 2, 2}, structure::kGallbladder);
  map.voxels.set({2, 30, 2}, structure::kGallbladder);
  const LabelVolume before = map.voxels;
  const std::vector<LesionSplit> splits = split_lesions(map);
  QCOMPARE(splits.size(), std::size_t{1});
  QCOMPARE(splits[0].lesion, kLesion);
  const auto second = static_cast<Label>(structure::kFirstLesion + 1);
  const auto fourth = static_cast<Label>(structure::kFirstLesion + 3);
  QCOMPARE(splits[0].others, (std::vector<Label>{second, fourth}));
  QCOMPARE(splits[0].left, 0L);
  QCOMPARE(map.voxels.at({40, 20, 20}), kLesion);
  QCOMPARE(map.voxels.at({70, 24, 20}), second);
  QCOMPARE(map.voxels.at({5, 5, 8}), fourth);
  QCOMPARE(map.voxels.at({20, 30, 30}), structure::kFirstLesion);
  QCOMPARE(map.voxels.at({2, 30, 2}), structure::kGallbladder);
  const auto count = [](const LabelVolume& voxels) {
    return std::ranges::count_if(voxels.dense(), [](Label label) { return label != 0; });
  };
  QCOMPARE(count(map.voxels), count(before));
  QCOMPARE(map.infos.size(), std::size_t{3});
  QCOMPARE(map.infos[0].name, std::string("all tumours"));
  QCOMPARE(map.infos[1].name, std::string("lesion_2"));
  QCOMPARE(map.infos[2].terminology, std::string("a~terminology"));
  QVERIFY(split_lesions(map).empty());
}

void LesionPiecesTest::WhereNoLabelIsFreeTheSmallestStay() {
  LabelMap map{empty(1.0), {}};
  for (int label = structure::kFirstLesion + 1; label < structure::kLastLesion; ++label)
    map.voxels.set({label % 40, label / 40, 39}, static_cast<Label>(label));
  put_ball(map.voxels, {50, 10, 10}, 4.0, structure::kFirstLesion);
  put_ball(map.voxels, {70, 10, 10}, 3.0, structure::kFirstLesion);
  map.voxels.set({50, 35, 10}, structure::kFirstLesion);
  const std::vector<LesionSplit> splits = split_lesions(map);
  QCOMPARE(splits.size(), std::size_t{1});
  QCOMPARE(splits[0].others, std::vector<Label>{structure::kLastLesion});
  QCOMPARE(splits[0].left, 1L);
  QCOMPARE(map.voxels.at({70, 10, 10}), structure::kLastLesion);
  QCOMPARE(map.voxels.at({50, 35, 10}), structure::kFirstLesion);
}

QTEST_APPLESS_MAIN(LesionPiecesTest)
#include "lesion_pieces_test.moc"
