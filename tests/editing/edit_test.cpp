// SPDX-License-Identifier: GPL-3.0-or-later
// What every edit keeps to, and the tools that reshape labels.
#include "glisson/editing/edit.h"

#include <QTest>

#include "edit_applied.h"
#include "edit_random.h"
#include "glisson/core/error.h"

using namespace glisson;
using namespace glisson::editing;
using namespace glisson::test;

class EditTest : public QObject {
  Q_OBJECT
 private slots:
  void RandomEditsAreWhatANaiveProgramDoes_data();
  void RandomEditsAreWhatANaiveProgramDoes();
  void IslandsByClickAndSplit();
  void SplittingManyIslandsSaysWhatWasLeft();
  void AFilledVolumeIsOneBrick();
  void WhatIsTakenFromAVesselLeavesNoHole();
  void ABranchBeyondItsNeckChangesHands();
  void InformationOfLabelsIsKeptAndAdded();
  void InformationInAnyOrderIsKept();
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
  QVERIFY_THROWS_EXCEPTION(InputError, applied(labels, image, tool));
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

void EditTest::InformationInAnyOrderIsKept() {
  // As a file lists its segments in the order in which they were drawn.
  const VolumeGrid grid = test::fine_grid(2.0);
  LabelMap labels;
  labels.voxels = LabelVolume(grid);
  labels.infos = {structure_info(structure::kFirstLesion), structure_info(structure::kParenchyma)};
  labels.infos[1].terminology = "kept as it is";
  const Paint paint{structure::kParenchyma,
                    false,
                    Paint::Brush::ball,
                    4e-3,
                    2,
                    test::one_point(test::p_at(grid, test::middle_of(grid)))};
  const Edited edited = test::applied(labels, test::noisy(grid, 1), paint);
  QVERIFY(edited.voxels_changed > 0);
  QCOMPARE(edited.labels.infos.size(), std::size_t(2));
  QCOMPARE(edited.labels.infos[1].terminology, std::string("kept as it is"));
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
