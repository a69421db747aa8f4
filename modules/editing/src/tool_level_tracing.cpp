// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/level_tracing.h"

#include "describe.h"
#include "edit_shape.h"
#include "level_region.h"

namespace glisson::editing {
namespace {

Cancellable<Canvas> apply(const LevelTracing& tool, Task& task) {
  const VolumeGrid& grid = task.grid();
  const int axis = tool.normal_axis, u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  const int number = voxel_at(grid, tool.p_in_ct, "level_tracing")[axis];
  const Eigen::Vector3d index = grid.index_of(Point<CtFrame>(tool.p_in_ct));
  VoxelBox box = whole_box(grid);
  box.low[axis] = number;
  box.high[axis] = number + 1;
  const LevelRegion region = traced(smoothed_slice(task.image, axis, number), {index[u], index[v]});
  if (region.open) task.notes.emplace_back("level_tracing.open");
  Canvas canvas = task.canvas(box);
  const bool gathers = tool.erase && lies_in_liver(tool.label);
  std::vector<Eigen::Vector3i> lost;
  const bool done =
      canvas.rewrite(box, task.context.part(0.0, 0.8), [&](int i, int j, int k, Label old) -> Label {
        const std::array<int, 3> place = {i, j, k};
        if (region.mask.voxels[region.mask.offset(place[static_cast<std::size_t>(u)],
                                                  place[static_cast<std::size_t>(v)], 0)] == 0)
          return old;
        if (!tool.erase) return tool.label;
        if (tool.label != structure::kBackground && old != tool.label) return old;
        if (gathers) lost.emplace_back(i, j, k);
        return gathers ? old : structure::kBackground;
      });
  if (!done || !take_away(canvas, lost, tool.label, task.context.part(0.8, 1.0))) return std::nullopt;
  return canvas;
}

Description<LevelTracing> description() {
  return {"level_tracing",
          50,
          {label_field<LevelTracing>("label", &LevelTracing::label,
                                     [](const LevelTracing& t) { return t.erase; }),
           flag_field("erase", &LevelTracing::erase), axis_field(&LevelTracing::normal_axis),
           point_field(&LevelTracing::p_in_ct)},
          {"level_tracing", "level_tracing.erase"},
          [](const LevelTracing& t) {
            return StepName{t.erase ? "level_tracing.erase" : "level_tracing", t.label, 0.0};
          },
          apply,
          [](const LevelTracing&) { return true; }};
}

}  // namespace

const ToolKind& LevelTracing::kind() {
  static const Described<LevelTracing> kKind(description());
  return kKind;
}
const ToolKind& level_tracing_tool() { return LevelTracing::kind(); }

}  // namespace glisson::editing
