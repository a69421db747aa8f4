// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/threshold.h"

#include <cmath>

#include "describe.h"

namespace glisson::editing {
namespace {

Cancellable<Canvas> apply(const Threshold& tool, Task& task) {
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

/// The low end judges the range.
void check_range(const SettingsCheck& check, const Threshold& t) {
  if (!(t.low <= t.high) || !std::isfinite(t.low) || !std::isfinite(t.high))
    check.refuse("low", "is " + std::to_string(t.low) + " with a high of " + std::to_string(t.high),
                 "Choose a low that is not above the high");
}

Description<Threshold> description() {
  return {"threshold",
          20,
          {label_field("label", &Threshold::label),
           number_field("low_hu", &Threshold::low, "HU").checked(check_range),
           number_field("high_hu", &Threshold::high, "HU"), flag_field("replace", &Threshold::replace)},
          {"threshold"},
          [](const Threshold& t) {
            return StepName{"threshold", t.label, 0.0};
          },
          apply};
}

}  // namespace

const ToolKind& Threshold::kind() {
  static const Described<Threshold> kKind(description());
  return kKind;
}
const ToolKind& threshold_tool() { return Threshold::kind(); }

}  // namespace glisson::editing
