// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/edit.h"

#include <QtTest>
#include <thread>

#include "edit_naive.h"
#include "edit_random.h"
#include "glisson/core/error.h"

using namespace glisson;
using namespace glisson::segmentation;
using namespace glisson::test;

namespace {

Points one_point(const Eigen::Vector3d& p) {
  Points path(1, 3);
  path.row(0) = p.transpose();
  return path;
}

/// Fine cubes in a box of 40 mm, so that volumes are those of the shapes.
VolumeGrid fine_grid(double spacing_mm = 0.5) {
  VolumeGrid grid;
  grid.size = Eigen::Vector3i::Constant(static_cast<int>(40.0 / spacing_mm));
  grid.spacing_mm.setConstant(spacing_mm);
  return grid;
}

double ml_of(const LabelMap& labels, Label label) {
  const std::vector<long> counts = labels.voxels.histogram();
  return label < counts.size() ? 1e-3 * counts[label] * labels.voxels.grid().voxel_volume_mm3() : 0.0;
}

Edited applied(const LabelMap& labels, const Image& image, const Tool& tool,
               const EditableRegion& region = {}) {
  return apply_edit(labels, image, {tool, region}, RunContext()).value();
}

Image noisy(const VolumeGrid& grid, unsigned seed) {
  std::mt19937 random(seed);
  return image_of(grid, [&](const Eigen::Vector3i&) { return static_cast<double>(random() % 200) - 100.0; });
}

}  // namespace

class EditTest : public QObject {
  Q_OBJECT
 private slots:
  void RandomEditsAreWhatANaiveProgramDoes_data();
  void RandomEditsAreWhatANaiveProgramDoes();
  void APaintedBallAndCapsuleHaveTheirVolumes();
  void ADiscLiesInItsSliceOnly();
  void ABrushFinerThanAVoxelLeavesNoGap();
  void EraseUndoesPaintOnBackground();
  void ABranchThatIsRubbedOutLeavesNoHoleInTheLiver();
  void ScissorsOfACircleCutACylinder();
  void ScissorsInPerspectiveCutACone();
  void WhatIsBehindTheViewerIsOutside();
  void AStrokeCopiesOnlyTheBricksUnderIt();
  void LevelTracingFindsADiscOfKnownSize();
  void LevelTracingOfAnErasedDiscTakesItAway();
  void IslandsByClickAndSplit();
  void SplittingManyIslandsSaysWhatWasLeft();
  void AFilledVolumeIsOneBrick();
  void WhatIsTakenFromAVesselLeavesNoHole();
  void ABranchBeyondItsNeckChangesHands();
  void InformationOfLabelsIsKeptAndAdded();
  void CancelLeavesNothing_data();
  void CancelLeavesNothing();
  void StepsHaveTheirNames();
};

void EditTest::RandomEditsAreWhatANaiveProgramDoes_data() {
  QTest::addColumn<int>("grid");
  QTest::newRow("straight") << 0;
  QTest::newRow("oblique") << 1;
  QTest::newRow("flipped") << 2;
}

void EditTest::RandomEditsAreWhatANaiveProgramDoes() {
  QFETCH(int, grid);
  const VolumeGrid g = awkward_grids()[static_cast<std::size_t>(grid)];
  const Image image = noisy(g, 3);
  RandomEdits edits(g, static_cast<unsigned>(11 + grid));
  int changed = 0;
  for (int n = 0; n < 80; ++n) {
    const LabelMap labels = small_anatomy(g, static_cast<unsigned>(n));
    const Edit edit = edits.next();
    const std::string fault = fault_of(labels, image, edit);
    const StepName name = step_name(edit);
    QVERIFY2(fault.empty(), qPrintable(QString("edit %1, %2 of %3: %4")
                                           .arg(n)
                                           .arg(QString::fromStdString(name.code))
                                           .arg(name.label)
                                           .arg(QString::fromStdString(fault))));
    changed += applied(labels, image, edit.tool, edit.region).voxels_changed > 0;
  }
  QVERIFY2(changed > 30, qPrintable(QString::number(changed)));
}

void EditTest::APaintedBallAndCapsuleHaveTheirVolumes() {
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

void EditTest::ADiscLiesInItsSliceOnly() {
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

void EditTest::ABrushFinerThanAVoxelLeavesNoGap() {
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

void EditTest::EraseUndoesPaintOnBackground() {
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

void EditTest::ABranchThatIsRubbedOutLeavesNoHoleInTheLiver() {
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

void EditTest::ScissorsOfACircleCutACylinder() {
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

void EditTest::ScissorsInPerspectiveCutACone() {
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

void EditTest::WhatIsBehindTheViewerIsOutside() {
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

void EditTest::AStrokeCopiesOnlyTheBricksUnderIt() {
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

void EditTest::LevelTracingFindsADiscOfKnownSize() {
  for (const VolumeGrid& base : awkward_grids())
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {1.0, -1.0}) {
        VolumeGrid grid = base;
        grid.spacing_mm.setConstant(0.6);
        grid.size = {70, 66, 62};
        std::mt19937 random(8);
        std::normal_distribution<double> noise(0.0, 8.0);
        // A bar along the axis with an edge 1.2 mm wide, brighter or darker than what is about it.
        const Eigen::Vector3d c = middle_of(grid);
        const double radius = 11.0;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const Image image = image_of(grid, [&](const Eigen::Vector3i& at) {
          const Eigen::Vector3d p = place_of(grid, at) - c;
          const double inside = std::clamp((radius - std::hypot(p[u], p[v])) / 1.2 + 0.5, 0.0, 1.0);
          return 60.0 + sign * 100.0 * inside + noise(random);
        });
        Eigen::Vector3d click = c;
        click[axis] = 0.6 * 30;
        click[u] += radius;  // on the edge, half way between the two levels
        LevelTracing tool{structure::kGallbladder, false, axis, p_at(grid, click)};
        const Edited traced = applied({LabelVolume(grid), {}}, image, tool);
        const double area = static_cast<double>(traced.voxels_changed) * 0.36 / (M_PI * radius * radius);
        QVERIFY2(std::abs(area - 1.0) < 0.06, qPrintable(QString("axis %1: %2").arg(axis).arg(area)));
        QVERIFY(traced.notes.empty());
        const int slice = 30;
        for (const auto& [number, before, after] : traced.labels.voxels.changes_since(LabelVolume(grid)))
          for (int n = 0; n < LabelVolume::kSide; ++n) {
            Eigen::Vector3i place = LabelVolume::kSide * traced.labels.voxels.brick_place(number);
            place[axis] += n;
            if (grid.contains(place) && place[axis] != slice)
              QCOMPARE(traced.labels.voxels.at(place), Label{0});
          }
      }
}

void EditTest::LevelTracingOfAnErasedDiscTakesItAway() {
  const VolumeGrid grid = fine_grid(1.0);
  const Image image = image_of(grid, [&](const Eigen::Vector3i& v) {
    return (v - Eigen::Vector3i(20, 20, v.z())).norm() < 8.0 ? 100.0 : 0.0;
  });
  const LabelMap labels = labels_of(grid, [](const Eigen::Vector3i& v) {
    return v.x() < 20 ? structure::kParenchyma : structure::kPortalVein;
  });
  LevelTracing tool{structure::kParenchyma, true, 2, {0.020, 0.012, 0.010}};
  const Edited erased = applied(labels, image, tool);
  QVERIFY(erased.voxels_changed > 60 && erased.voxels_changed < 140);  // the half that is parenchyma
  QCOMPARE(erased.labels.voxels.at({15, 20, 10}), structure::kBackground);
  QCOMPARE(erased.labels.voxels.at({25, 20, 10}), structure::kPortalVein);
  QCOMPARE(erased.labels.voxels.at({15, 20, 11}), structure::kParenchyma);
  tool.label = structure::kBackground;  // of any label
  QCOMPARE(applied(labels, image, tool).labels.voxels.at({25, 20, 10}), structure::kBackground);
}

void EditTest::IslandsByClickAndSplit() {
  const VolumeGrid grid = fine_grid(1.0);
  const Image image = image_of(grid, [](const Eigen::Vector3i&) { return 0.0; });
  // Boxes of 10, 6 and 4 voxels a side; the last two touch at an edge only.
  const auto box = [](const Eigen::Vector3i& v, int low, int side) {
    return (v.array() >= low).all() && (v.array() < low + side).all();
  };
  const LabelMap labels = labels_of(grid, [&](const Eigen::Vector3i& v) -> Label {
    const bool third = v.x() >= 30 && v.x() < 34 && v.y() >= 30 && v.y() < 34 && v.z() >= 24 && v.z() < 28;
    return box(v, 2, 10) || box(v, 24, 6) || third ? structure::kFirstLesion : structure::kBackground;
  });
  const auto voxels = [&](const Edited& e, Label label) { return std::lround(1e3 * ml_of(e.labels, label)); };
  Islands tool{structure::kFirstLesion, Islands::Operation::keep_largest, 1.0, {0.025, 0.025, 0.025}};
  QCOMPARE(voxels(applied(labels, image, tool), 16), 1000L);
  tool.operation = Islands::Operation::keep_clicked;
  QCOMPARE(voxels(applied(labels, image, tool), 16), 216L);
  tool.operation = Islands::Operation::remove_clicked;
  QCOMPARE(voxels(applied(labels, image, tool), 16), 1064L);
  tool.operation = Islands::Operation::remove_small;
  tool.smallest_ml = 0.1;
  QCOMPARE(voxels(applied(labels, image, tool), 16), 1216L);
  tool.operation = Islands::Operation::split;
  const Edited split = applied(labels, image, tool);
  QCOMPARE(voxels(split, 16), 1000L);
  QCOMPARE(voxels(split, 17), 216L);
  QCOMPARE(voxels(split, 18), 64L);
  QCOMPARE(split.labels.infos.size(), std::size_t(3));
  tool.operation = Islands::Operation::keep_clicked;
  tool.p_in_ct = {0.020, 0.020, 0.020};
  QVERIFY_EXCEPTION_THROWN(applied(labels, image, tool), InputError);
}

void EditTest::SplittingManyIslandsSaysWhatWasLeft() {
  const VolumeGrid grid = fine_grid(1.0);
  const Image image = image_of(grid, [](const Eigen::Vector3i&) { return 0.0; });
  const LabelMap labels = labels_of(grid, [](const Eigen::Vector3i& v) {
    return v.x() % 3 == 0 && v.y() == 5 && v.z() == 5 ? structure::kPortalVein : structure::kBackground;
  });
  const Edited split =
      applied(labels, image,
              Islands{structure::kPortalVein, Islands::Operation::split, 1.0, Eigen::Vector3d::Zero()});
  // 14 dots: one stays, nine become "other" structures, four find no label.
  QCOMPARE(split.notes, std::vector<std::string>{"islands_left:4"});
  QCOMPARE(split.voxels_changed, 9L);
}

void EditTest::AFilledVolumeIsOneBrick() {
  VolumeGrid grid;
  grid.size = {96, 96, 96};
  const Image image = image_of(grid, [](const Eigen::Vector3i&) { return 0.0; });
  const Edited full =
      applied({LabelVolume(grid), {}}, image, Logical{structure::kParenchyma, Logical::Operation::fill, 0});
  QCOMPARE(full.voxels_changed, grid.voxel_count());
  for (std::size_t n = 1; n < full.labels.voxels.brick_count(); ++n)
    QCOMPARE(full.labels.voxels.brick(n), full.labels.voxels.brick(0));
  const Edited clear =
      applied(full.labels, image, Logical{structure::kParenchyma, Logical::Operation::clear, 0});
  for (std::size_t n = 0; n < clear.labels.voxels.brick_count(); ++n) QVERIFY(!clear.labels.voxels.brick(n));
}

void EditTest::WhatIsTakenFromAVesselLeavesNoHole() {
  const VolumeGrid grid = fine_grid(1.0);
  // A bright vessel through the liver, whose right half is air, and an island of it in either half.
  const auto vessel = [](const Eigen::Vector3i& v) { return std::hypot(v.y() - 20, v.z() - 20) < 4.0; };
  const LabelMap labels = labels_of(grid, [&](const Eigen::Vector3i& v) -> Label {
    const bool island =
        (v - Eigen::Vector3i(8, 32, 20)).norm() < 2.5 || (v - Eigen::Vector3i(32, 32, 20)).norm() < 2.5;
    if (vessel(v) || island) return structure::kPortalVein;
    return v.x() < 20 ? structure::kParenchyma : structure::kBackground;
  });
  const Image image = image_of(grid, [&](const Eigen::Vector3i& v) { return vessel(v) ? 150.0 : 50.0; });
  const auto expect = [&](const Edited& edited, const Eigen::Vector3i& in_liver,
                          const Eigen::Vector3i& in_air) {
    return edited.labels.voxels.at(in_liver) == structure::kParenchyma &&
           edited.labels.voxels.at(in_air) == structure::kBackground;
  };
  const Islands islands{structure::kPortalVein, Islands::Operation::keep_largest, 1.0,
                        Eigen::Vector3d::Zero()};
  QVERIFY(expect(applied(labels, image, islands), {8, 32, 20}, {32, 32, 20}));
  Scissors cut;
  cut.label = structure::kPortalVein;
  cut.view_from_ct << 1, 0, 0, -0.02, 0, 1, 0, -0.02, 0, 0, 0, 1;
  cut.outline = circle(1.0);
  QVERIFY(expect(applied(labels, image, cut), {8, 20, 20}, {32, 20, 20}));
  const LevelTracing traced{structure::kPortalVein, true, 2, {0.010, 0.020, 0.020}};
  const Edited one_slice = applied(labels, image, traced);
  QVERIFY(one_slice.voxels_changed > 100);
  QVERIFY(expect(one_slice, {8, 20, 20}, {32, 20, 20}));
  // Of any label: what is erased is gone.
  cut.label = structure::kBackground;
  QCOMPARE(applied(labels, image, cut).labels.voxels.at({8, 20, 20}), structure::kBackground);
}

void EditTest::ABranchBeyondItsNeckChangesHands() {
  const VolumeGrid grid = fine_grid();
  const Image image = noisy(grid, 6);
  // A trunk along x, thickest at its root, a neck of 1.2 mm upwards at its middle, a branch beyond it.
  const LabelMap labels = labels_of(grid, [&](const Eigen::Vector3i& v) -> Label {
    const Eigen::Vector3d p = 0.5 * v.cast<double>();
    if (std::hypot(p.y() - 10.0, p.z() - 20.0) < (p.x() < 8.0 ? 6.0 : 4.0)) return structure::kPortalVein;
    const double across = std::hypot(p.x() - 20.0, p.z() - 20.0);
    const bool branch = p.y() > 10.0 && across < (p.y() < 18.0 ? 1.2 : 3.0);
    return branch ? structure::kPortalVein : structure::kBackground;
  });
  const ReassignBranch tool{structure::kPortalVein, structure::kHepaticVeins, {0.020, 0.017, 0.020}};
  const Edited edited = applied(labels, image, tool);
  for (const int y : {40, 60, 79}) QCOMPARE(edited.labels.voxels.at({40, y, 40}), structure::kHepaticVeins);
  for (const int x : {0, 40, 79}) QCOMPARE(edited.labels.voxels.at({x, 20, 40}), structure::kPortalVein);
  const long branch = std::lround(M_PI * 9.0 * 22.0 / 0.125);
  QVERIFY2(std::abs(edited.voxels_changed - branch) < branch / 10,
           qPrintable(QString::number(edited.voxels_changed)));
  // The region holds for it as for every tool, and a cut leaves background.
  EditableRegion dark;
  dark.intensity = std::array<double, 2>{-1000.0, 0.0};
  const Edited half =
      applied(labels, image, ReassignBranch{tool.label, structure::kBackground, tool.p_in_ct}, dark);
  QVERIFY(half.voxels_changed > branch / 3 && half.voxels_changed < 2 * branch / 3);
  for (int y = 40; y < 80; ++y)
    QCOMPARE(half.labels.voxels.at({40, y, 40}) == structure::kBackground, image.at({40, y, 40}) <= 0);
}

void EditTest::InformationOfLabelsIsKeptAndAdded() {
  const VolumeGrid grid = fine_grid(1.0);
  const Image image = image_of(grid, [](const Eigen::Vector3i&) { return 0.0; });
  LabelMap labels = labels_of(grid, [](const Eigen::Vector3i& v) {
    return v.x() < 5 ? structure::kParenchyma : structure::kBackground;
  });
  labels.infos = {structure_info(structure::kParenchyma)};
  labels.infos[0].terminology = "kept as it is";
  const Edited more = applied(
      labels, image, Logical{structure::kPortalVein, Logical::Operation::copy, structure::kParenchyma});
  QCOMPARE(more.labels.infos.size(), std::size_t(2));
  QCOMPARE(more.labels.infos[0].terminology, std::string("kept as it is"));
  QCOMPARE(more.labels.infos[1].name, std::string("portal_vein"));
}

void EditTest::CancelLeavesNothing_data() {
  QTest::addColumn<int>("tool");
  for (int n = 0; n < 10; ++n) QTest::newRow(qPrintable(QString("tool %1").arg(n))) << n;
}

void EditTest::CancelLeavesNothing() {
  QFETCH(int, tool);
  const VolumeGrid grid = awkward_grids()[0];
  const Image image = noisy(grid, 5);
  const LabelMap labels = small_anatomy(grid, 5);
  const std::vector<Label> before = labels.voxels.dense();
  const std::vector<Tool> tools = {
      Paint{structure::kParenchyma, false, Paint::Brush::ball, 5e-3, 2,
            one_point(p_at(grid, middle_of(grid)))},
      Threshold{structure::kParenchyma, -10, 30, false},
      Islands{structure::kParenchyma, Islands::Operation::keep_largest, 1.0, Eigen::Vector3d::Zero()},
      FillHoles{structure::kParenchyma, false},
      Smooth{structure::kParenchyma, Smooth::Method::median, 2e-3},
      Smooth{structure::kParenchyma, Smooth::Method::joint, 2e-3},
      Margin{structure::kParenchyma, 2e-3},
      InterpolateSlices{structure::kPortalVein, 0},
      GrowFromSeeds{{1, 2, 3}, 5e-3, {}},
      Logical{structure::kParenchyma, Logical::Operation::invert, 0}};
  const Edit edit{tools[static_cast<std::size_t>(tool)], {}};
  QVERIFY(apply_edit(labels, image, edit, RunContext()).has_value());
  // Asked for before it starts, and in the middle of it.
  for (const double when : {-1.0, 0.0, 0.3}) {
    const auto flag = std::make_shared<CancelFlag>();
    if (when < 0.0) flag->request();
    double last = 0.0;
    const RunContext context(
        [&](double fraction, std::string_view) {
          QVERIFY(fraction >= last - 1e-9 && fraction <= 1.0);
          last = fraction;
          if (fraction >= when) flag->request();
        },
        flag, 1);
    const auto edited = apply_edit(labels, image, edit, context);
    // A tool that reports nothing between its start and its end has nothing to cancel in between.
    if (when <= 0.0 || last < 1.0) QVERIFY(!edited.has_value());
    QVERIFY(labels.voxels.dense() == before);
  }
}

void EditTest::StepsHaveTheirNames() {
  Paint paint{structure::kPortalVein, false, Paint::Brush::ball, 10e-3, 2, {}};
  QCOMPARE(step_name({paint, {}}), (StepName{"paint", structure::kPortalVein, 10e-3}));
  paint.erase = true;
  QCOMPARE(step_name({paint, {}}).code, std::string("erase"));
  QCOMPARE(step_name({Margin{structure::kFirstLesion, -4e-3}, {}}),
           (StepName{"margin.shrink", structure::kFirstLesion, 4e-3}));
  QCOMPARE(step_name({Smooth{structure::kParenchyma, Smooth::Method::joint, 3e-3}, {}}),
           (StepName{"smooth.joint", 0, 3e-3}));
  QCOMPARE(step_name({GrowFromSeeds{{1, 7}, 0.02, {7}}, {}}), (StepName{"grow_from_seeds", 1, 0.02}));
  QCOMPARE(step_name({GrowFromSeeds{{1, 2}, 0.02, {}}, {}}).label, Label{0});
  QCOMPARE(step_name({Islands{structure::kFirstLesion, Islands::Operation::remove_clicked, 1.0,
                              Eigen::Vector3d::Zero()},
                      {}})
               .code,
           std::string("islands.remove_clicked"));
  QVERIFY(is_local(paint) && is_local(LevelTracing()) && is_local(ReassignBranch()));
  QVERIFY(!is_local(Scissors()) && !is_local(Threshold()) && !is_local(Margin()));
}

QTEST_APPLESS_MAIN(EditTest)
#include "edit_test.moc"
