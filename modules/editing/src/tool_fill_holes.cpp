// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/fill_holes.h"

#include "describe.h"
#include "edit_runs.h"
#include "edit_shape.h"

namespace glisson::editing {
namespace {

Cancellable<Canvas> apply(const FillHoles& tool, Task& task) {
  const LabelSet shape = shape_of(tool.label);
  const VoxelBox box = box_of(task.labels.voxels, shape);
  Canvas canvas = task.canvas(box);
  if (box.empty()) return canvas;
  // Beyond the box there is nothing that could close a hole: its faces are the outside.
  const Mask mask = mask_in(task.labels.voxels, box, shape);
  task.context.progress(0.2, "segmentation.edit");
  Mask filled = mask;
  if (tool.in_slices) {
    filled = slice_holes_filled(mask);
  } else {
    const Runs gaps(mask, 0);
    std::vector<bool> holes = gaps.at_faces();
    holes.flip();
    gaps.write(holes, 1, filled);
  }
  task.context.progress(0.6, "segmentation.edit");
  const Eigen::Vector3i low = box.low;
  const bool done = canvas.rewrite(box, task.context.part(0.6, 1.0), [&](int i, int j, int k, Label old) {
    const bool gains =
        may_gain(tool.label, old) && filled.voxels[filled.offset(i - low.x(), j - low.y(), k - low.z())] != 0;
    return gains ? tool.label : old;
  });
  if (!done) return std::nullopt;
  return canvas;
}

Description<FillHoles> description() {
  return {"fill_holes",
          70,
          {label_field("label", &FillHoles::label), flag_field("in_slices", &FillHoles::in_slices)},
          {"fill_holes"},
          [](const FillHoles& t) {
            return StepName{"fill_holes", t.label, 0.0};
          },
          apply};
}

}  // namespace

const ToolKind& FillHoles::kind() {
  static const Described<FillHoles> kKind(description());
  return kKind;
}
const ToolKind& fill_holes_tool() { return FillHoles::kind(); }

}  // namespace glisson::editing
