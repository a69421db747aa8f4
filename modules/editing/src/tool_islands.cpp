// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/islands.h"

#include <algorithm>
#include <numeric>

#include "describe.h"
#include "edit_runs.h"
#include "edit_shape.h"
#include "glisson/core/error.h"

namespace glisson::editing {
namespace {

constexpr const char* kName = "islands";

using Operation = Islands::Operation;

bool is_clicked(const Islands& tool) {
  return tool.operation == Operation::keep_clicked || tool.operation == Operation::remove_clicked;
}

/// The labels that no voxel has and nobody has locked.
std::vector<Label> labels_for_parts(const Task& task, Label like) {
  const std::vector<long> counts = task.labels.voxels.histogram();
  const std::vector<Label>& locked = task.region.locked;
  return free_labels(like, [&](Label label) {
    return (label < counts.size() && counts[label] > 0) || std::ranges::find(locked, label) != locked.end();
  });
}

/// Components by falling size; equal ones as they come in memory.
std::vector<std::size_t> by_size(const Runs& islands) {
  std::vector<std::size_t> order(islands.sizes().size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return islands.sizes()[a] > islands.sizes()[b]; });
  return order;
}

std::size_t clicked_island(const Islands& tool, const Task& task, const Runs& islands, const VoxelBox& box) {
  const Eigen::Vector3i v = voxel_at(task.grid(), tool.p_in_ct, kName);
  const Label there = task.labels.voxels.at(v);
  if (there != tool.label)
    throw InputError(kName, "p_in_ct",
                     "lies on " + structure_name(there) + ", not on " + structure_name(tool.label),
                     "Click a part of " + structure_name(tool.label));
  return islands.component_at(v - box.low);
}

/// What each component becomes.
std::vector<Label> fates(const Islands& tool, Task& task, const Runs& islands, const VoxelBox& box) {
  const std::size_t count = islands.sizes().size();
  std::vector<Label> fate(count, tool.label);
  const std::vector<std::size_t> order = by_size(islands);
  switch (tool.operation) {
    case Operation::keep_largest:
      std::fill(fate.begin(), fate.end(), structure::kBackground);
      if (count > 0) fate[order.front()] = tool.label;
      break;
    case Operation::remove_small:
      for (std::size_t n = 0; n < count; ++n)
        if (1e-3 * static_cast<double>(islands.sizes()[n]) * task.grid().voxel_volume_mm3() <
            tool.smallest_ml)
          fate[n] = structure::kBackground;
      break;
    case Operation::keep_clicked:
      std::fill(fate.begin(), fate.end(), structure::kBackground);
      fate[clicked_island(tool, task, islands, box)] = tool.label;
      break;
    case Operation::remove_clicked:
      fate[clicked_island(tool, task, islands, box)] = structure::kBackground;
      break;
    case Operation::split: {
      const std::vector<Label> free = labels_for_parts(task, tool.label);
      for (std::size_t n = 1; n < std::min(count, free.size() + 1); ++n) fate[order[n]] = free[n - 1];
      if (count > free.size() + 1)
        task.notes.push_back("islands_left:" + std::to_string(count - free.size() - 1));
      break;
    }
  }
  return fate;
}

Cancellable<Canvas> apply(const Islands& tool, Task& task) {
  const bool clicked = is_clicked(tool);
  const VoxelBox box = box_of(task.labels.voxels, {tool.label});
  Canvas canvas = task.canvas(box);
  if (clicked)
    voxel_at(task.grid(), tool.p_in_ct, kName);  // outside is refused even where nothing is labelled
  if (box.empty() && !clicked) return canvas;
  const Runs islands(box.empty() ? Mask() : mask_in(task.labels.voxels, box, {tool.label}), 1);
  task.context.progress(0.5, "segmentation.edit");
  if (task.context.cancelled()) return std::nullopt;
  const std::vector<Label> fate = fates(tool, task, islands, box);
  const auto ny = static_cast<std::size_t>(box.size().y());
  std::vector<Eigen::Vector3i> lost;
  std::size_t n = 0;
  for (const Runs::Run& run : islands.runs()) {
    if (++n % 4096 == 0 && task.context.cancelled()) return std::nullopt;
    const Label becomes = fate[run.component];
    if (becomes == tool.label) continue;
    const int j = box.low.y() + static_cast<int>(run.row % ny),
              k = box.low.z() + static_cast<int>(run.row / ny);
    for (int i = run.first; becomes == structure::kBackground && i < run.end; ++i)
      lost.emplace_back(box.low.x() + i, j, k);
    if (becomes != structure::kBackground)
      canvas.rewrite_row(j, k, box.low.x() + run.first, box.low.x() + run.end,
                         [&](int, int, int, Label) { return becomes; });
  }
  if (!take_away(canvas, lost, tool.label, task.context.part(0.6, 1.0))) return std::nullopt;
  return canvas;
}

const Names<Operation>& operations() {
  static const Names<Operation> kNames = {{"keep_largest", Operation::keep_largest},
                                          {"remove_small", Operation::remove_small},
                                          {"keep_clicked", Operation::keep_clicked},
                                          {"remove_clicked", Operation::remove_clicked},
                                          {"split", Operation::split}};
  return kNames;
}

bool removes_small(const Islands& t) { return t.operation == Operation::remove_small; }

void check_smallest(const SettingsCheck& check, const Islands& t) {
  if (removes_small(t) && !(t.smallest_ml > 0.0 && t.smallest_ml <= 1e4))
    check.refuse("smallest_ml", "is " + std::to_string(t.smallest_ml),
                 "Choose more than 0 and at most 10000 ml");
}

Description<Islands> description() {
  return {
      kName,
      60,
      {label_field("label", &Islands::label), choice_field("operation", &Islands::operation, operations()),
       number_field("smallest_ml", &Islands::smallest_ml, "ml")
           .needed("for `remove_small`", removes_small)
           .checked(check_smallest),
       point_field(&Islands::p_in_ct).needed("for `keep_clicked` and `remove_clicked`", is_clicked)},
      steps_of(kName, operations()),
      [](const Islands& t) {
        return StepName{"islands." + name_of(operations(), t.operation), t.label, 0.0};
      },
      apply};
}

}  // namespace

const ToolKind& Islands::kind() {
  static const Described<Islands> kKind(description());
  return kKind;
}
const ToolKind& islands_tool() { return Islands::kind(); }

}  // namespace glisson::editing
