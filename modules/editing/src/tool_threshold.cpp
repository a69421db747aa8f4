// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_tools.h"

namespace glisson::editing {
namespace {

/// Where voxels can change at all, as the editable region says without a look at single voxels.
VoxelBox reachable(const Task& task) {
  using Area = EditableRegion::Area;
  const VoxelBox whole = whole_box(task.grid());
  switch (task.region.area) {
    case Area::inside_label:
      return box_of(task.labels.voxels, {task.region.label});
    case Area::inside_liver:
      // What the liver encloses is no larger than the liver.
      return box_of(task.labels.voxels, liver_tissue());
    default:
      return whole;
  }
}

}  // namespace

Cancellable<Canvas> apply_tool(const Threshold& tool, Task& task) {
  // What the label had before may lie anywhere and is judged by the region like the rest.
  const VoxelBox box = reachable(task);
  Canvas canvas = task.canvas(box);
  const std::int16_t* voxels = task.image.voxels->data();
  const VolumeGrid& grid = task.grid();
  const bool done = canvas.rewrite(box, task.context, [&](int i, int j, int k, Label old) -> Label {
    const double intensity = voxels[grid.offset({i, j, k})];
    if (intensity >= tool.low && intensity <= tool.high) return tool.label;
    return tool.replace && old == tool.label ? structure::kBackground : old;
  });
  if (!done) return std::nullopt;
  return canvas;
}

Cancellable<Canvas> apply_tool(const Logical& tool, Task& task) {
  using Operation = Logical::Operation;
  const LabelVolume& labels = task.labels.voxels;
  const Label mine = tool.label, other = tool.other;
  VoxelBox box;
  switch (tool.operation) {
    case Operation::invert:
    case Operation::fill:
      box = reachable(task);
      break;
    case Operation::copy:
      box = box_of(labels, {mine, other});
      break;
    case Operation::add:
      box = box_of(labels, {other});
      break;
    default:
      box = box_of(labels, {mine});
  }
  Canvas canvas = task.canvas(box);
  const bool done = canvas.rewrite(box, task.context, [&](int, int, int, Label old) -> Label {
    switch (tool.operation) {
      case Operation::copy:
        return old == other ? mine : old == mine ? structure::kBackground : old;
      case Operation::add:
        return old == other ? mine : old;
      case Operation::subtract:
        return old == mine && mine == other ? structure::kBackground : old;
      case Operation::intersect:
        return old == mine && mine != other ? structure::kBackground : old;
      case Operation::invert:
        return old == mine ? structure::kBackground : mine;
      case Operation::clear:
        return old == mine ? structure::kBackground : old;
      case Operation::fill:
        break;
    }
    return mine;
  });
  if (!done) return std::nullopt;
  return canvas;
}

}  // namespace glisson::editing
