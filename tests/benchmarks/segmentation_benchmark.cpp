// SPDX-License-Identifier: GPL-3.0-or-later
// The editing tools on a CT of 512 x 512 x 500 voxels of 0.7 mm with a liver of 1.5 l, two trees and a
// lesion, as ratios to a stroke of the brush and to the one dense copy of the labels that a program without
// bricks makes for its undo. One thread. The ratios are what holds on another machine.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "glisson/editing/edit.h"
#include "glisson/editing/tools/fill_holes.h"
#include "glisson/editing/tools/grow.h"
#include "glisson/editing/tools/interpolate.h"
#include "glisson/editing/tools/islands.h"
#include "glisson/editing/tools/level_tracing.h"
#include "glisson/editing/tools/logical.h"
#include "glisson/editing/tools/margin.h"
#include "glisson/editing/tools/paint.h"
#include "glisson/editing/tools/scissors.h"
#include "glisson/editing/tools/smooth.h"
#include "glisson/editing/tools/threshold.h"
#include "large_scene.h"

namespace {

using namespace glisson;
using namespace glisson::editing;
using namespace glisson::bench;

/// The labels with little of the liver drawn: what growing and interpolating start from.
const LabelMap& sketch(int every_slices, double about_mm) {
  static std::map<std::pair<int, double>, LabelMap> made;
  LabelMap& labels = made[{every_slices, about_mm}];
  if (!labels.voxels.empty()) return labels;
  const VolumeGrid& grid = scene().image.grid;
  std::vector<Label> dense = scene().labels.voxels.dense();
  std::size_t at = 0;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i, ++at) {
        const bool drawn = k % every_slices == 0 && std::abs(j - 256) * 0.7 < about_mm;
        if (!drawn) dense[at] = structure::kBackground;
      }
  labels.voxels = LabelVolume(grid, dense);
  return labels;
}

Points stroke() {
  Points path(2, 3);
  path.row(0) = scene().p_at({-20.0, 30.0, 20.0}).transpose();
  path.row(1) = scene().p_at({-17.0, 32.0, 20.0}).transpose();
  return path;
}

Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> lasso(double radius) {
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> outline(150, 2);
  for (int n = 0; n < 150; ++n) {
    const double angle = 2.0 * M_PI * n / 150.0, r = radius * (1.0 + 0.2 * std::sin(5.0 * angle));
    outline.row(n) << r * std::cos(angle), r * std::sin(angle);
  }
  return outline;
}

Scissors scissors(bool in_slice) {
  Scissors tool;
  tool.label = structure::kBackground;
  const Eigen::Vector3d eye = scene().p_at({0.0, 0.0, in_slice ? 0.0 : -400.0});
  if (in_slice) {
    tool.view_from_ct << 1, 0, 0, -eye.x(), 0, 1, 0, -eye.y(), 0, 0, 0, 1;
    tool.outline = lasso(0.04);
    tool.slab = Scissors::Slab{Eigen::Vector3d::UnitZ(), scene().p_at({0.0, 0.0, 20.3}).z(), 0.35e-3};
  } else {
    tool.view_from_ct << Eigen::Matrix3d::Identity(), -eye;
    tool.outline = lasso(0.1);
  }
  return tool;
}

EditableRegion inside_liver_only() {
  EditableRegion region;
  region.area = EditableRegion::Area::inside_liver;
  return region;
}

struct Case {
  std::string name;
  Edit edit;
  const LabelMap* labels;
};

std::vector<Case> cases() {
  const LabelMap* full = &scene().labels;
  const Paint ball{structure::kPortalVein, false, Paint::Brush::ball, 10e-3, 2, stroke()};
  Paint disc = ball;
  disc.brush = Paint::Brush::disc;
  Paint on_vessel = ball;
  for (Eigen::Index n = 0; n < 2; ++n)
    on_vessel.path.row(n) = scene().p_at({3.0 * static_cast<double>(n), 8.0, -4.0}).transpose();
  on_vessel.label = structure::kHepaticVeins;
  const Label liver = structure::kParenchyma, portal = structure::kPortalVein;
  return {
      {"paint/ball_10_mm", {ball, {}}, full},
      {"paint/disc_10_mm", {disc, {}}, full},
      {"paint/ball_10_mm_inside_liver", {on_vessel, inside_liver_only()}, full},
      {"scissors/in_slice", {scissors(true), {}}, full},
      {"level_tracing",
       {LevelTracing{structure::kGallbladder, false, 2, scene().p_at({55.0, 10.0, 5.0})}, {}},
       full},
      {"scissors/in_3d", {scissors(false), {}}, full},
      {"threshold/whole_volume", {Threshold{structure::kArtery, 150, 300, false}, {}}, full},
      {"threshold/inside_liver", {Threshold{structure::kArtery, 150, 300, false}, inside_liver_only()}, full},
      {"islands/keep_largest",
       {Islands{liver, Islands::Operation::keep_largest, 1.0, Eigen::Vector3d::Zero()}, {}},
       full},
      {"fill_holes", {FillHoles{liver, false}, {}}, full},
      {"fill_holes/in_slices", {FillHoles{liver, true}, {}}, full},
      {"smooth/median_3_mm", {Smooth{liver, Smooth::Method::median, 3e-3}, {}}, full},
      {"smooth/closing_3_mm", {Smooth{liver, Smooth::Method::closing, 3e-3}, {}}, full},
      {"smooth/opening_2_mm_portal", {Smooth{portal, Smooth::Method::opening, 2e-3}, {}}, full},
      {"smooth/joint_3_mm", {Smooth{0, Smooth::Method::joint, 3e-3}, {}}, full},
      {"margin/lesion_10_mm", {Margin{structure::kFirstLesion, 10e-3}, {}}, full},
      {"margin/liver_3_mm", {Margin{liver, 3e-3}, {}}, full},
      {"interpolate/every_8_slices", {InterpolateSlices{liver, 2}, {}}, &sketch(8, 1e3)},
      {"grow_from_seeds/20_mm",
       {GrowFromSeeds{{liver, portal, structure::kHepaticVeins}, 20e-3, {}}, {}},
       &sketch(16, 20.0)},
      {"logical/add", {Logical{liver, Logical::Operation::add, portal}, {}}, full}};
}

/// Prints a table of ratios after the benchmarks.
class Ratios : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) times_.emplace_back(run.benchmark_name(), run.GetAdjustedCPUTime());
    ConsoleReporter::ReportRuns(runs);
  }
  void print_table() const {
    const double stroke = time_of("paint/ball_10_mm"), copy = time_of("copy/dense_labels");
    if (stroke <= 0.0 || copy <= 0.0) return;
    std::printf("\n%-32s %10s %12s %12s\n", "edit", "CPU ms", "x a stroke", "x a copy");
    for (const auto& [name, time] : times_)
      std::printf("%-32s %10.2f %12.1f %12.2f\n", name.c_str(), time, time / stroke, time / copy);
  }

 private:
  double time_of(const std::string& name) const {
    for (const auto& [each, time] : times_)
      if (each.rfind(name + "/min_time", 0) == 0 || each == name) return time;
    return 0.0;
  }
  std::vector<std::pair<std::string, double>> times_;
};

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  benchmark::RegisterBenchmark("copy/dense_labels", [](benchmark::State& state) {
    const std::vector<Label> dense = scene().labels.voxels.dense();
    for (auto _ : state) {
      std::vector<Label> copy = dense;
      benchmark::DoNotOptimize(copy.data());
    }
  })->Unit(benchmark::kMillisecond);
  for (const Case& each : cases())
    benchmark::RegisterBenchmark(each.name.c_str(), [each](benchmark::State& state) {
      for (auto _ : state) {
        const auto edited = apply_edit(*each.labels, scene().image, each.edit, RunContext());
        if (edited->voxels_changed == 0 && each.name.find("islands") == std::string::npos &&
            each.name.find("closing") == std::string::npos && each.name.find("holes") == std::string::npos)
          state.SkipWithError("nothing was changed");
        state.counters["voxels"] = static_cast<double>(edited->voxels_changed);
      }
    })->Unit(benchmark::kMillisecond);
  Ratios reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print_table();
  return 0;
}
