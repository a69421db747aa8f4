// SPDX-License-Identifier: GPL-3.0-or-later
// From a tool's settings and what the mouse did to an edit.
#include <QFile>
#include <QTest>
#include <map>
#include <set>

#include "glisson/core/error.h"
#include "glisson/editing/history.h"
#include "glisson/editing/tools/fill_holes.h"
#include "glisson/editing/tools/grow.h"
#include "glisson/editing/tools/interpolate.h"
#include "glisson/editing/tools/islands.h"
#include "glisson/editing/tools/level_tracing.h"
#include "glisson/editing/tools/logical.h"
#include "glisson/editing/tools/margin.h"
#include "glisson/editing/tools/paint.h"
#include "glisson/editing/tools/reassign.h"
#include "glisson/editing/tools/scissors.h"
#include "glisson/editing/tools/smooth.h"
#include "glisson/editing/tools/threshold.h"
#include "glisson/engine/step_kind.h"
#include "glisson/ui/segmentation/edit_texts.h"
#include "segmentation_strokes.h"

namespace glisson {
namespace {

using editing::Islands;
using editing::Logical;
using editing::Paint;
using editing::Scissors;
using scene::Plane;
using ui::edit_tool;
using ui::EditObstacle;
using ui::EditSettings;
using ui::EditTool;

Points path_of(int count) {
  Points path(count, 3);
  for (int i = 0; i < count; ++i) path.row(i) << 1e-3 * i, 2e-3, 3e-3;
  return path;
}

/// As a hand sets it on the tool's page.
void set_field(EditSettings& settings, const char* tool, const char* object, double value) {
  for (const ui::PageField& field : edit_tool(tool)->page)
    if (field.object == std::string(object)) return field.set(settings, value);
  QFAIL(object);
}

Eigen::Vector2d seen(const Scissors& cut, const Eigen::Vector3d& p) {
  const Eigen::Vector3d h = cut.view_from_ct * p.homogeneous();
  return h.head<2>() / h[2];
}

}  // namespace

class SegmentationToolsTest : public QObject {
  Q_OBJECT
 private slots:
  void EveryToolHasItsOwnKeyAndName();
  void SlicesAreAcrossTheVoxelAxisOfTheirPlane();
  void BrushPaintsWhatIsChosenAndCtrlErases();
  void DiscIsPaintedInEveryLayerOfATiltedVolume();
  void DiscBetweenTwoLayersStaysInTheOneThatIsShown();
  void BrushGrowsAndShrinksByTheWheel();
  void SliceCutSeesTheSlicesPixels();
  void SliceCutIsOneLayerASlabOrEverything();
  void CtrlInvertsTheCut();
  void VolumeCutKeepsTheView();
  void ClicksCarryThePlace();
  void BranchGoesToTheOtherTree();
  void WholeToolsTakeTheirSettings();
  void GrowLeavesOutWhatIsLockedOrOther();
  void RegionGoesWithEveryEdit();
  void ObstaclesAreNamed();
  void ToolsOfTheMouseHaveNoWholeEdit();
  void StepsAreNamedForPeople();
  void EveryToolOfTheEditorHasAnIconAndNamesForItsSteps();
  void PagesOfferWhatTheToolsTake();
  void TheManualHasTheTable();
};

void SegmentationToolsTest::EveryToolHasItsOwnKeyAndName() {
  std::set<char> keys;
  std::set<std::string> codes;
  for (const EditTool tool : ui::edit_tools()) {
    keys.insert(tool->key);
    codes.insert(tool->code);
    QVERIFY(!ui::tool_text(tool).isEmpty() && !ui::tool_hint(tool, {}).isEmpty());
  }
  QCOMPARE(keys.size(), ui::edit_tools().size());
  QCOMPARE(codes.size(), ui::edit_tools().size());
  QCOMPARE(edit_tool("paint")->key, 'P');
  QCOMPARE(edit_tool("erase")->key, 'E');
  QCOMPARE(edit_tool("scissors")->key, 'X');
}

void SegmentationToolsTest::SlicesAreAcrossTheVoxelAxisOfTheirPlane() {
  const VolumeGrid grid = permuted_grid();
  QCOMPARE(ui::voxel_axis_across(grid, Plane::axial), 0);     // z is i
  QCOMPARE(ui::voxel_axis_across(grid, Plane::coronal), 2);   // y is k
  QCOMPARE(ui::voxel_axis_across(grid, Plane::sagittal), 1);  // x is j
}

void SegmentationToolsTest::BrushPaintsWhatIsChosenAndCtrlErases() {
  EditSettings settings;
  settings.label = structure::kPortalVein;
  settings.brush_radius = 4e-3;
  const VolumeGrid grid = permuted_grid();
  const auto made = [&](EditTool tool, bool invert) {
    return stroke(tool, settings, grid, Plane::coronal, path_of(3), invert).tool.as<Paint>();
  };
  const Paint paint = made(edit_tool("paint"), false);
  QVERIFY(!paint.erase && paint.label == structure::kPortalVein && paint.radius == 4e-3);
  QVERIFY(paint.brush == Paint::Brush::disc && paint.normal_axis == 2);
  for (Eigen::Index i = 0; i < 3; ++i) {  // along the drag, in the closest layer of voxels
    const Eigen::Vector3d wanted = grid.index_of(Point<CtFrame>(path_of(3).row(i).transpose()));
    const Eigen::Vector3d got = grid.index_of(Point<CtFrame>(paint.path.row(i).transpose()));
    QVERIFY((got - wanted).head<2>().norm() < 1e-9);
    QVERIFY(std::abs(got[2] - std::round(wanted[2])) < 1e-9);
  }
  QVERIFY(made(edit_tool("paint"), true).erase);
  QVERIFY(made(edit_tool("erase"), false).erase);
  QVERIFY(!made(edit_tool("erase"), true).erase);
  settings.erase_any = true;
  settings.ball = true;
  QCOMPARE(made(edit_tool("erase"), false).label, structure::kBackground);
  QCOMPARE(made(edit_tool("erase"), true).label, structure::kPortalVein);
  QVERIFY(made(edit_tool("erase"), false).brush == Paint::Brush::ball);
  QVERIFY(made(edit_tool("erase"), false).path == path_of(3));  // a ball is where it is
  QVERIFY_THROWS_EXCEPTION(PreconditionError, made(edit_tool("smooth"), false));
}

void SegmentationToolsTest::DiscIsPaintedInEveryLayerOfATiltedVolume() {
  Image image;
  image.grid = tilted_grid(10.0);
  const VolumeGrid& grid = image.grid;
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(
      static_cast<std::size_t>(grid.voxel_count()), std::int16_t{100});
  EditSettings settings;
  settings.brush_radius = 1e-3;
  for (const int count : {2, 41}) {  // a fast hand and a slow one
    const auto edits = strokes(edit_tool("paint"), settings, grid, Plane::axial, way_through(grid, count));
    QCOMPARE(edits.size(), std::size_t{8});  // 40 mm sin 10 degrees
    LabelMap labels{LabelVolume(grid), {}};
    editing::History history;
    for (const editing::Edit& edit : edits) {
      const LabelMap before = labels;
      labels = editing::apply_edit(before, image, edit, RunContext()).value().labels;
      history = history.with(editing::step_name(edit), before, labels, 7);
    }
    // What was under the pointer, in whichever layer.
    const Points places = way_through(grid, 401);
    for (Eigen::Index n = 0; n < places.rows(); ++n) {
      const Point<CtFrame> p(Eigen::Vector3d(places.row(n).transpose()));
      const Eigen::Vector3i voxel = grid.index_of(p).array().round().cast<int>().matrix();
      QCOMPARE(labels.voxels.at(voxel), structure::kParenchyma);
    }
    QCOMPARE(history.steps().size(), std::size_t{1});
    QVERIFY(history.undo(labels).first.voxels == LabelVolume(grid));
  }
  Points outside = way_through(grid, 2);
  outside.col(2).array() += 1.0;
  QVERIFY(strokes(edit_tool("paint"), settings, grid, Plane::axial, outside).empty());
  settings.ball = true;
  QCOMPARE(strokes(edit_tool("paint"), settings, grid, Plane::axial, way_through(grid, 41)).size(),
           std::size_t{1});
}

void SegmentationToolsTest::DiscBetweenTwoLayersStaysInTheOneThatIsShown() {
  for (const double degrees : {1e-10, -1e-10}) {  // what is left of a rotation in a file's numbers
    const VolumeGrid grid = tilted_grid(degrees);
    const Points path = way_through(grid, 9);
    const auto slice = scene::slice_geometry(grid, Plane::axial, grid.p_in_ct({19.5, 29.5, 24.5}));
    const auto edits = ui::brush_edits(edit_tool("paint"), {}, grid, slice, path, false);
    QCOMPARE(edits.size(), std::size_t{1});
    const Paint paint = edits[0].tool.as<Paint>();
    QCOMPARE(paint.path.rows(), path.rows());
    const double shown = std::round(grid.index_of(slice.p_in_ct({0.0, 0.0})).z());
    for (Eigen::Index n = 0; n < path.rows(); ++n) {
      const Point<CtFrame> p(Eigen::Vector3d(paint.path.row(n).transpose()));
      QVERIFY(std::abs(grid.index_of(p).z() - shown) < 1e-6);
    }
  }
}

void SegmentationToolsTest::BrushGrowsAndShrinksByTheWheel() {
  double radius = 5e-3;
  for (int i = 0; i < 100; ++i) {
    const double next = ui::brush_after(radius, 1.0);
    QVERIFY(next > radius || next == ui::kLargestBrush);
    radius = next;
  }
  QCOMPARE(radius, ui::kLargestBrush);
  for (int i = 0; i < 200; ++i) {
    const double next = ui::brush_after(radius, -1.0);
    QVERIFY(next < radius || next == ui::kSmallestBrush);
    radius = next;
  }
  QCOMPARE(radius, ui::kSmallestBrush);
}

void SegmentationToolsTest::SliceCutSeesTheSlicesPixels() {
  const VolumeGrid grid = permuted_grid();
  for (const Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal}) {
    const auto slice = scene::slice_geometry(grid, plane, grid.p_in_ct({20, 25, 30}));
    Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> outline(3, 2);
    outline << 3, 4, 20, 5, 8, 17;
    const auto cut = ui::slice_cut({}, grid, slice, outline, false).tool.as<Scissors>();
    QVERIFY(cut.outline == outline);
    const Eigen::Vector2d pixel(7.25, 11.5);
    const Eigen::Vector3d off = 0.01 * slice.right.cross(slice.down).normalized();
    QVERIFY((seen(cut, slice.p_in_ct(pixel).xyz + off) - pixel).norm() < 1e-9);
  }
}

void SegmentationToolsTest::SliceCutIsOneLayerASlabOrEverything() {
  const VolumeGrid grid = permuted_grid();
  // Between two layers of voxels (2.5 mm apart along z), closer to layer 20.
  const auto slice = scene::slice_geometry(grid, Plane::axial, grid.p_in_ct({20.4, 25, 30}));
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> outline(3, 2);
  outline << 0, 0, 30, 0, 0, 30;
  EditSettings settings;
  const auto depth_of = [&](double i) {
    const auto cut = ui::slice_cut(settings, grid, slice, outline, false).tool.as<Scissors>();
    if (!cut.slab) return true;
    const Eigen::Vector3d p = grid.p_in_ct({i, 25, 30}).xyz;
    return std::abs(cut.slab->normal.dot(p) - cut.slab->offset) <= cut.slab->half_thickness;
  };
  QVERIFY(depth_of(20) && !depth_of(21) && !depth_of(19));
  auto& how = settings.of<ui::Cut>();
  how.depth = ui::CutDepth::slab;
  how.slab = 11e-3;
  QVERIFY(depth_of(18) && depth_of(22) && !depth_of(17) && !depth_of(23));
  how.slab = 1e-3;  // thinner than a layer: the layer all the same
  QVERIFY(depth_of(20) && !depth_of(21));
  how.depth = ui::CutDepth::through;
  QVERIFY(depth_of(0) && depth_of(39));
}

void SegmentationToolsTest::CtrlInvertsTheCut() {
  const VolumeGrid grid = permuted_grid();
  const auto slice = scene::slice_geometry(grid, Plane::axial, grid.p_in_ct({20, 25, 30}));
  EditSettings settings;
  const auto operation = [&](Scissors::Operation cut, bool invert) {
    settings.of<Scissors>().operation = cut;
    return ui::slice_cut(settings, grid, slice, {}, invert).tool.as<Scissors>().operation;
  };
  using Operation = Scissors::Operation;
  QCOMPARE(operation(Operation::erase_inside, false), Operation::erase_inside);
  QCOMPARE(operation(Operation::erase_inside, true), Operation::fill_inside);
  QCOMPARE(operation(Operation::fill_inside, true), Operation::erase_inside);
  QCOMPARE(operation(Operation::erase_outside, true), Operation::erase_inside);
  settings.of<ui::Cut>().any_label = true;
  settings.of<Scissors>().operation = Operation::erase_inside;
  QCOMPARE(ui::slice_cut(settings, grid, slice, {}, false).tool.as<Scissors>().label, structure::kBackground);
  QCOMPARE(ui::slice_cut(settings, grid, slice, {}, true).tool.as<Scissors>().label,
           structure::kParenchyma);  // what is filled needs a label
}

void SegmentationToolsTest::VolumeCutKeepsTheView() {
  ui::VolumeLasso lasso;
  lasso.view_from_ct.setRandom();
  lasso.outline.resize(4, 2);
  lasso.outline.setRandom();
  const auto cut = ui::volume_cut({}, lasso, false).tool.as<Scissors>();
  QVERIFY(cut.view_from_ct == lasso.view_from_ct && cut.outline == lasso.outline && !cut.slab);
}

void SegmentationToolsTest::ClicksCarryThePlace() {
  const VolumeGrid grid = permuted_grid();
  const Point<CtFrame> p(0.01, 0.02, 0.03);
  EditSettings settings;
  settings.label = structure::kFirstLesion;
  const auto traced = ui::click_edit(edit_tool("level_tracing"), settings, grid, Plane::axial, p, 0, true);
  const auto& tracing = traced->tool.as<editing::LevelTracing>();
  QVERIFY(tracing.p_in_ct == p.xyz && tracing.label == structure::kFirstLesion && tracing.erase);
  QCOMPARE(tracing.normal_axis, 0);
  settings.of<Islands>().operation = Islands::Operation::remove_clicked;
  const auto clicked = ui::click_edit(edit_tool("islands"), settings, grid, Plane::axial, p, 0, false);
  QVERIFY(clicked->tool.as<Islands>().p_in_ct == p.xyz);
  QCOMPARE(clicked->tool.as<Islands>().operation, Islands::Operation::remove_clicked);
  const auto opposite = ui::click_edit(edit_tool("islands"), settings, grid, Plane::axial, p, 0, true);
  QCOMPARE(opposite->tool.as<Islands>().operation, Islands::Operation::keep_clicked);
  QVERIFY_THROWS_EXCEPTION(PreconditionError,
                           ui::click_edit(edit_tool("paint"), settings, grid, Plane::axial, p, 0, false));
}

void SegmentationToolsTest::BranchGoesToTheOtherTree() {
  const VolumeGrid grid = permuted_grid();
  EditSettings settings;
  const auto branch = [&](Label clicked, bool invert) {
    return ui::click_edit(edit_tool("move_branch"), settings, grid, Plane::axial, {}, clicked, invert);
  };
  const auto to = [&](Label clicked, bool invert) {
    return branch(clicked, invert)->tool.as<editing::ReassignBranch>();
  };
  QCOMPARE(to(structure::kPortalVein, false).to, structure::kHepaticVeins);
  QCOMPARE(to(structure::kPortalVein, false).label, structure::kPortalVein);
  QCOMPARE(to(structure::kHepaticVeins, false).to, structure::kPortalVein);
  QCOMPARE(to(structure::kHepaticVeins, true).to, structure::kBackground);
  set_field(settings, "move_branch", "branch_goes", 1.0);
  QCOMPARE(to(structure::kPortalVein, false).to, structure::kBackground);
  QVERIFY(!branch(structure::kParenchyma, false) && !branch(structure::kBackground, false));
}

void SegmentationToolsTest::WholeToolsTakeTheirSettings() {
  const VolumeGrid grid = permuted_grid();
  EditSettings settings;
  settings.label = structure::kVenaCava;
  settings.of<editing::Threshold>() = {structure::kParenchyma, 120, 240, true};
  set_field(settings, "margin", "margin_direction", 1.0);
  set_field(settings, "margin", "margin_distance", 2.0);
  set_field(settings, "interpolate", "interpolate_plane", 2.0);
  settings.of<Logical>().operation = Logical::Operation::subtract;
  set_field(settings, "logical", "logical_other", structure::kGallbladder);
  const auto made = [&](EditTool tool) { return ui::whole_edit(tool, settings, grid, {1, 2}).tool; };
  QVERIFY((made(edit_tool("threshold")).as<editing::Threshold>() ==
           editing::Threshold{structure::kVenaCava, 120, 240, true}));
  QCOMPARE(made(edit_tool("margin")).as<editing::Margin>().distance, -2e-3);
  QCOMPARE(made(edit_tool("interpolate")).as<editing::InterpolateSlices>().normal_axis, 1);
  QCOMPARE(made(edit_tool("logical")).as<Logical>().other, structure::kGallbladder);
  settings.of<Logical>().operation = Logical::Operation::clear;
  QCOMPARE(made(edit_tool("logical")).as<Logical>().other, structure::kBackground);
  QCOMPARE(made(edit_tool("smooth")).as<editing::Smooth>().radius, editing::Smooth().radius);
  QVERIFY(!made(edit_tool("fill_holes")).as<editing::FillHoles>().in_slices);
  QCOMPARE(made(edit_tool("islands")).as<Islands>().operation, Islands::Operation::keep_largest);
}

void SegmentationToolsTest::GrowLeavesOutWhatIsLockedOrOther() {
  EditSettings settings;
  settings.region.locked = {structure::kVenaCava, structure::kHepaticVeins};
  const std::vector<Label> present = {structure::kParenchyma,   structure::kPortalVein,
                                      structure::kHepaticVeins, structure::kVenaCava,
                                      structure::kFirstOther,   structure::kFirstLesion};
  const auto grow =
      ui::whole_edit(edit_tool("grow"), settings, permuted_grid(), present).tool.as<editing::GrowFromSeeds>();
  QVERIFY((grow.labels ==
           std::vector<Label>{structure::kParenchyma, structure::kPortalVein, structure::kFirstLesion}));
  QVERIFY(grow.rivals == std::vector<Label>{structure::kFirstOther});
}

void SegmentationToolsTest::RegionGoesWithEveryEdit() {
  const VolumeGrid grid = permuted_grid();
  EditSettings settings;
  settings.region.area = editing::EditableRegion::Area::inside_label;
  settings.region.label = structure::kParenchyma;
  settings.region.intensity = {100.0, 200.0};
  settings.region.locked = {structure::kPortalVein};
  const auto slice = scene::slice_geometry(grid, Plane::axial, grid.p_in_ct({20, 25, 30}));
  QVERIFY(stroke(edit_tool("paint"), settings, grid, Plane::axial, path_of(1)).region == settings.region);
  QVERIFY(ui::slice_cut(settings, grid, slice, {}, false).region == settings.region);
  QVERIFY(ui::volume_cut(settings, {}, false).region == settings.region);
  QVERIFY(ui::whole_edit(edit_tool("smooth"), settings, grid, {1}).region == settings.region);
  QVERIFY(ui::click_edit(edit_tool("level_tracing"), settings, grid, Plane::axial, {}, 0, false)->region ==
          settings.region);
}

void SegmentationToolsTest::ObstaclesAreNamed() {
  EditSettings settings;
  const std::vector<Label> liver = {structure::kParenchyma};
  QCOMPARE(ui::obstacle_of(edit_tool("paint"), settings, {}), EditObstacle::none);
  QCOMPARE(ui::obstacle_of(edit_tool("smooth"), settings, {}), EditObstacle::label_empty);
  QCOMPARE(ui::obstacle_of(edit_tool("smooth"), settings, liver), EditObstacle::none);
  QCOMPARE(ui::obstacle_of(edit_tool("grow"), settings, liver), EditObstacle::one_label);
  QCOMPARE(ui::obstacle_of(edit_tool("logical"), settings, liver), EditObstacle::other_empty);
  set_field(settings, "logical", "logical_other", settings.label);
  QCOMPARE(ui::obstacle_of(edit_tool("logical"), settings, liver), EditObstacle::same_label);
  settings.region.locked = liver;
  QCOMPARE(ui::obstacle_of(edit_tool("paint"), settings, liver), EditObstacle::label_locked);
  for (const EditObstacle obstacle :
       {EditObstacle::label_locked, EditObstacle::label_empty, EditObstacle::other_empty,
        EditObstacle::same_label, EditObstacle::one_label})
    QVERIFY(!ui::obstacle_text(obstacle).isEmpty());
}

void SegmentationToolsTest::ToolsOfTheMouseHaveNoWholeEdit() {
  EditSettings settings;
  for (const EditTool tool :
       {edit_tool("paint"), edit_tool("scissors"), edit_tool("move_branch"), edit_tool("level_tracing")}) {
    QVERIFY(!ui::is_previewed(tool, settings));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, ui::whole_edit(tool, settings, permuted_grid(), {1, 2}));
  }
  QVERIFY(ui::is_previewed(edit_tool("islands"), settings));
  settings.of<Islands>().operation = Islands::Operation::keep_clicked;
  QVERIFY(!ui::is_previewed(edit_tool("islands"), settings));
  QVERIFY(!ui::is_previewed(nullptr, settings));
}

void SegmentationToolsTest::StepsAreNamedForPeople() {
  QCOMPARE(ui::step_text({"paint", structure::kPortalVein, 5e-3}),
           QStringLiteral("Paint, 10 mm, Portal vein"));
  QCOMPARE(ui::step_text({"margin.grow", structure::kParenchyma, 2.5e-3}),
           QStringLiteral("Margin: grow, 2.5 mm, Liver"));
  QCOMPARE(ui::step_text({"segment", structure::kBackground, 0.0}), QStringLiteral("Segment"));
  QCOMPARE(ui::step_text({"segment_around_hand", structure::kBackground, 0.0}),
           QStringLiteral("Segment, corrections kept"));
  for (const engine::StepKind* kind : engine::step_kinds()) {
    QVERIFY2(*kind->text != '\0', kind->code.data());
    QCOMPARE(ui::step_text(kind->name()), QString::fromUtf8(kind->text));
  }
}

void SegmentationToolsTest::EveryToolOfTheEditorHasAnIconAndNamesForItsSteps() {
  std::set<std::string> steps;
  for (const EditTool tool : ui::edit_tools()) {
    for (const ui::WindowTool::Step& step : tool->steps) QVERIFY2(steps.insert(step.code).second, step.code);
    const std::string icon = "/resources/icons/tool_" + tool->code + ".svg";
    QVERIFY2(QFile::exists(qEnvironmentVariable("GLISSON_SOURCE_DIR") + QString::fromStdString(icon)),
             icon.c_str());
  }
  for (const editing::ToolKind* kind : editing::tools())
    for (const std::string& step : kind->steps()) {
      QVERIFY2(ui::knows_step(step), step.c_str());
      QCOMPARE(steps.erase(step), std::size_t(1));
    }
  QVERIFY2(steps.empty(), "a tool of the window names a step that no edit has");
}

void SegmentationToolsTest::PagesOfferWhatTheToolsTake() {
  const std::map<std::string, std::pair<std::string, std::string>> fields = {
      {"scissors_operation", {"scissors", "operation"}},
      {"islands_operation", {"islands", "operation"}},
      {"smooth_method", {"smooth", "method"}},
      {"logical_operation", {"logical", "operation"}},
      {"brush_shape", {"paint", "brush"}}};
  std::size_t compared = 0;
  for (const EditTool tool : ui::edit_tools()) {
    QVERIFY(tool->page_of == nullptr || !edit_tool(tool->page_of)->page.empty());
    for (const ui::PageField& field : tool->page) {
      QVERIFY2(field.set != nullptr && *field.object != '\0', tool->code.c_str());
      // What is set is what is shown.
      EditSettings settings;
      if (field.get) field.set(settings, field.get(settings));
      QVERIFY2(!field.get || settings == EditSettings(), field.object);
      const auto known = fields.find(field.object);
      if (known == fields.end()) continue;
      const auto [code, name] = known->second;
      for (const editing::ToolField& each : editing::tool_called(code)->fields())
        if (each.code == name) QCOMPARE(field.choices.size(), each.choices.size());
      ++compared;
    }
  }
  QCOMPARE(compared, fields.size());
}

void SegmentationToolsTest::TheManualHasTheTable() {
  QFile manual(qEnvironmentVariable("GLISSON_SOURCE_DIR") + QStringLiteral("/packaging/manual/manual.md"));
  QVERIFY(manual.open(QIODevice::ReadOnly));
  QVERIFY2(manual.readAll().contains(QByteArray::fromStdString(ui::tool_table())),
           ("packaging/manual/manual.md must hold, word for word:\n" + ui::tool_table()).c_str());
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::SegmentationToolsTest)
#include "segmentation_tools_test.moc"
