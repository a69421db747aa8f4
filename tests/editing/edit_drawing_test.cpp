// SPDX-License-Identifier: GPL-3.0-or-later
// What a hand draws: brushes and scissors against closed forms.
#include "glisson/editing/edit.h"

#include <QTest>

#include "edit_applied.h"
#include "edit_random.h"

using namespace glisson;
using namespace glisson::editing;
using namespace glisson::test;

class EditDrawingTest : public QObject {
  Q_OBJECT
 private slots:
  void APaintedBallAndCapsuleHaveTheirVolumes();
  void ADiscLiesInItsSliceOnly();
  void ABrushFinerThanAVoxelLeavesNoGap();
  void EraseUndoesPaintOnBackground();
  void ABranchThatIsRubbedOutLeavesNoHoleInTheLiver();
  void ScissorsOfACircleCutACylinder();
  void ScissorsInPerspectiveCutACone();
  void WhatIsBehindTheViewerIsOutside();
  void AStrokeCopiesOnlyTheBricksUnderIt();
};

void EditDrawingTest::APaintedBallAndCapsuleHaveTheirVolumes() {
  for (const VolumeGrid& base : awkward_grids()) {
    VolumeGrid grid = base;  // as awkward, and fine enough for a closed form
    grid.spacing_mm = {0.4, 0.5, 0.7};
    grid.size = {90, 80, 60};
    const Image image = image_of(grid, [](const Eigen::Vector3i&) { return 0.0; });
    const LabelMap empty{LabelVolume(grid), {}};
    Paint ball{
        structure::kPortalVein, false, Paint::Brush::ball, 9e-3, 2, one_point(p_at(grid, middle_of(grid)))};
    const double r = 0.9, volume = 4.0 / 3.0 * M_PI * r * r * r;  // cm
    const double painted = ml_of(applied(empty, image, ball).labels, structure::kPortalVein);
    QVERIFY2(std::abs(painted / volume - 1.0) < 0.01, qPrintable(QString::number(painted / volume)));
    ball.radius = 5e-3;
    ball.path.resize(2, 3);
    ball.path.row(0) = p_at(grid, middle_of(grid) - Eigen::Vector3d(6, 4, 5)).transpose();
    ball.path.row(1) = p_at(grid, middle_of(grid) + Eigen::Vector3d(6, 4, 5)).transpose();
    const double length = 0.2 * std::sqrt(36.0 + 16.0 + 25.0);
    const double capsule = 4.0 / 3.0 * M_PI * 0.125 + M_PI * 0.25 * length;
    const double drawn = ml_of(applied(empty, image, ball).labels, structure::kPortalVein);
    QVERIFY2(std::abs(drawn / capsule - 1.0) < 0.01, qPrintable(QString::number(drawn / capsule)));
  }
}

void EditDrawingTest::ADiscLiesInItsSliceOnly() {
  for (const VolumeGrid& grid : awkward_grids())
    for (int axis = 0; axis < 3; ++axis) {
      const Image image = image_of(grid, [](const Eigen::Vector3i&) { return 0.0; });
      const LabelMap empty{LabelVolume(grid), {}};
      const Eigen::Vector3i centre = grid.size / 2;
      const Paint disc{structure::kArtery,
                       false,
                       Paint::Brush::disc,
                       9e-3,
                       axis,
                       one_point(grid.p_in_ct(centre.cast<double>()).xyz)};
      const LabelMap labels = applied(empty, image, disc).labels;
      const VolumeGrid& g = grid;
      long count = 0;
      for (int k = 0; k < g.size.z(); ++k)
        for (int j = 0; j < g.size.y(); ++j)
          for (int i = 0; i < g.size.x(); ++i) {
            const Eigen::Vector3i v(i, j, k);
            if (labels.voxels.at(v) == 0) continue;
            ++count;
            QCOMPARE(v[axis], centre[axis]);
          }
      const double pixel = g.spacing_mm.prod() / g.spacing_mm[axis];
      const double area = static_cast<double>(count) * pixel / (M_PI * 81.0);
      QVERIFY2(std::abs(area - 1.0) < 0.03, qPrintable(QString::number(area)));
    }
}

void EditDrawingTest::ABrushFinerThanAVoxelLeavesNoGap() {
  const VolumeGrid grid = awkward_grids()[1];
  const Image image = image_of(grid, [](const Eigen::Vector3i&) { return 0.0; });
  Points path(2, 3);
  path.row(0) = grid.p_in_ct({3.3, 4.4, 5.3}).xyz.transpose();
  path.row(1) = grid.p_in_ct({40.2, 30.1, 28.8}).xyz.transpose();
  const LabelMap labels = applied({LabelVolume(grid), {}}, image,
                                  Paint{structure::kArtery, false, Paint::Brush::ball, 0.05e-3, 2, path})
                              .labels;
  QCOMPARE(labels.voxels.at({3, 4, 5}), structure::kArtery);
  QCOMPARE(labels.voxels.at({40, 30, 29}), structure::kArtery);
  // In every slice that the line passes there is a voxel.
  for (int i = 3; i <= 40; ++i) {
    bool any = false;
    for (int k = 0; k < grid.size.z(); ++k)
      for (int j = 0; j < grid.size.y(); ++j) any = any || labels.voxels.at({i, j, k}) != 0;
    QVERIFY2(any, qPrintable(QString::number(i)));
  }
}

void EditDrawingTest::EraseUndoesPaintOnBackground() {
  const VolumeGrid grid = awkward_grids()[2];
  const Image image = noisy(grid, 4);
  const LabelMap labels = small_anatomy(grid, 4);
  Paint paint{
      structure::kGallbladder, false, Paint::Brush::ball, 7e-3, 2, one_point(p_at(grid, {4.0, 4.0, 4.0}))};
  EditableRegion background;
  background.area = EditableRegion::Area::unlabelled;
  const Edited painted = applied(labels, image, paint, background);
  QVERIFY(painted.voxels_changed > 100);
  paint.erase = true;
  const Edited erased = applied(painted.labels, image, paint);
  QVERIFY(erased.labels.voxels == labels.voxels);
  QCOMPARE(erased.voxels_changed, painted.voxels_changed);
}

void EditDrawingTest::ABranchThatIsRubbedOutLeavesNoHoleInTheLiver() {
  VolumeGrid grid;
  grid.size = {50, 40, 30};
  LabelMap labels;
  labels.voxels = LabelVolume(grid);
  // A vessel of 9 mm that comes into a liver from the left.
  for (int k = 0; k < 30; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 50; ++i) {
        const bool vessel = std::hypot(j - 20, k - 15) < 4.6;
        if (vessel)
          labels.voxels.set({i, j, k}, structure::kPortalVein);
        else if (i >= 25)
          labels.voxels.set({i, j, k}, structure::kParenchyma);
      }
  Paint rub{structure::kPortalVein, true, Paint::Brush::ball, 3e-3, 2, Points(2, 3)};
  rub.path.row(0) = p_at(grid, {10.0, 20.0, 15.0}).transpose();
  rub.path.row(1) = p_at(grid, {40.0, 20.0, 15.0}).transpose();
  const Edited rubbed = applied(labels, noisy(grid, 4), rub);
  QCOMPARE(rubbed.labels.voxels.at({38, 20, 15}), structure::kParenchyma);  // deep in the vessel
  QCOMPARE(rubbed.labels.voxels.at({12, 20, 15}), structure::kBackground);
  QCOMPARE(rubbed.labels.voxels.at({38, 24, 15}), structure::kPortalVein);
}

void EditDrawingTest::ScissorsOfACircleCutACylinder() {
  const VolumeGrid grid = fine_grid();
  const Image image = image_of(grid, [](const Eigen::Vector3i&) { return 0.0; });
  const LabelMap full = labels_of(grid, [](const Eigen::Vector3i&) { return structure::kParenchyma; });
  Scissors cut;
  cut.view_from_ct << 1, 0, 0, -0.0198, 0, 1, 0, -0.0198, 0, 0, 0, 1;
  cut.outline = circle(0.01);
  const double all = ml_of(full, structure::kParenchyma), cylinder = M_PI * 1.0 * 4.0;
  double left = ml_of(applied(full, image, cut).labels, structure::kParenchyma);
  QVERIFY2(std::abs((all - left) / cylinder - 1.0) < 0.01,
           qPrintable(QString::number((all - left) / cylinder)));
  cut.operation = Scissors::Operation::erase_outside;
  left = ml_of(applied(full, image, cut).labels, structure::kParenchyma);
  QVERIFY(std::abs(left / cylinder - 1.0) < 0.01);
  // One slice of half a millimetre.
  cut.slab = Scissors::Slab{Eigen::Vector3d::UnitZ(), 0.010, 0.00025};
  cut.operation = Scissors::Operation::erase_inside;
  left = ml_of(applied(full, image, cut).labels, structure::kParenchyma);
  QVERIFY(std::abs((all - left) / (M_PI * 0.05) - 1.0) < 0.01);
  QVERIFY(is_local(cut));
}

void EditDrawingTest::ScissorsInPerspectiveCutACone() {
  const VolumeGrid grid = fine_grid();
  const Image image = image_of(grid, [](const Eigen::Vector3i&) { return 0.0; });
  Scissors cut;
  cut.operation = Scissors::Operation::fill_inside;
  // From 20 mm above the volume; half the opening is a tangent of 0.25, which stays inside the volume.
  const double above = 0.02;
  cut.view_from_ct = seen_from({0.0198, 0.0198, -above});
  cut.outline = circle(0.25);
  const double filled = ml_of(applied({LabelVolume(grid), {}}, image, cut).labels, structure::kParenchyma);
  const auto cone = [](double height_cm) { return M_PI / 3.0 * std::pow(0.25 * height_cm, 2) * height_cm; };
  const double frustum = cone(2.0 + 3.975) - cone(2.0 - 0.025);
  QVERIFY2(std::abs(filled / frustum - 1.0) < 0.01, qPrintable(QString::number(filled / frustum)));
  QVERIFY(!is_local(cut));
}

void EditDrawingTest::WhatIsBehindTheViewerIsOutside() {
  const VolumeGrid grid = fine_grid(1.0);
  const Image image = image_of(grid, [](const Eigen::Vector3i&) { return 0.0; });
  const LabelMap full = labels_of(grid, [](const Eigen::Vector3i&) { return structure::kParenchyma; });
  Scissors cut;
  cut.view_from_ct = seen_from({0.0198, 0.0198, 0.0203});
  cut.outline = circle(1e3);  // all that is in front
  const LabelMap behind = applied(full, image, cut).labels;
  cut.operation = Scissors::Operation::erase_outside;
  const LabelMap before = applied(full, image, cut).labels;
  for (int k = 0; k < 40; ++k) {
    QCOMPARE(behind.voxels.at({5, 6, k}), k <= 20 ? structure::kParenchyma : structure::kBackground);
    QCOMPARE(before.voxels.at({5, 6, k}), k > 20 ? structure::kParenchyma : structure::kBackground);
  }
}

void EditDrawingTest::AStrokeCopiesOnlyTheBricksUnderIt() {
  VolumeGrid grid;
  grid.size = {128, 128, 128};
  const Image image = image_of(grid, [](const Eigen::Vector3i&) { return 0.0; });
  const LabelMap labels = labels_of(grid, [](const Eigen::Vector3i&) { return structure::kParenchyma; });
  const Paint dot{structure::kFirstLesion,         false, Paint::Brush::ball, 6e-3, 2,
                  one_point({0.048, 0.048, 0.048})};
  QCOMPARE(applied(labels, image, dot).labels.voxels.bricks_differing_from(labels.voxels), 1);
  const Paint corner{structure::kFirstLesion,         false, Paint::Brush::ball, 6e-3, 2,
                     one_point({0.064, 0.064, 0.064})};
  QCOMPARE(applied(labels, image, corner).labels.voxels.bricks_differing_from(labels.voxels), 8);
  const Paint same{structure::kParenchyma,          false, Paint::Brush::ball, 6e-3, 2,
                   one_point({0.064, 0.064, 0.064})};
  const Edited nothing = applied(labels, image, same);
  QCOMPARE(nothing.labels.voxels.bricks_differing_from(labels.voxels), 0);
  QCOMPARE(nothing.notes, std::vector<std::string>{"nothing_changed"});
}

QTEST_APPLESS_MAIN(EditDrawingTest)
#include "edit_drawing_test.moc"
