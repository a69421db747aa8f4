// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/margin.h"

#include <cmath>

#include "describe.h"
#include "edit_shape.h"

namespace glisson::editing {
namespace {

constexpr double kLargest = 0.05;  ///< metres: beyond it a slip of the unit is likelier than a wish

Cancellable<Canvas> apply(const Margin& tool, Task& task) {
  const double distance_mm = 1e3 * std::abs(tool.distance);
  const bool grow = tool.distance > 0.0;
  // Vessels of the liver run on outside it: the parenchyma does not grow about those.
  const LabelSet shape = grow && tool.label == structure::kParenchyma ? liver_tissue() : shape_of(tool.label);
  const VoxelBox box =
      grown(box_of(task.labels.voxels, shape), task.grid(), distance_mm + task.grid().spacing_mm.maxCoeff());
  Canvas canvas = task.canvas(box);
  if (box.empty()) return canvas;
  Mask after = mask_in(task.labels.voxels, box, shape);
  after = grow ? dilated(after, distance_mm) : eroded(after, distance_mm);
  task.context.progress(0.8, "segmentation.edit");
  if (!reshape(canvas, box, after, tool.label, task.context.part(0.8, 1.0))) return std::nullopt;
  return canvas;
}

Description<Margin> description() {
  return {
      "margin",
      90,
      {label_field("label", &Margin::label), length_field("distance_mm", &Margin::distance, kLargest)
                                                 .checked([](const SettingsCheck& check, const Margin& t) {
                                                   check.length(std::abs(t.distance), "distance", kLargest);
                                                 })
                                                 .noted("negative: shrinks")},
      {"margin.grow", "margin.shrink"},
      [](const Margin& t) {
        return StepName{t.distance < 0.0 ? "margin.shrink" : "margin.grow", t.label, std::abs(t.distance)};
      },
      apply};
}

}  // namespace

const ToolKind& Margin::kind() {
  static const Described<Margin> kKind(description());
  return kKind;
}
const ToolKind& margin_tool() { return Margin::kind(); }

}  // namespace glisson::editing
