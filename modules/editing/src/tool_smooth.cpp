// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/smooth.h"

#include "describe.h"
#include "edit_shape.h"
#include "joint_smoothing.h"

namespace glisson::editing {
namespace {

constexpr double kLargest = 0.02;  ///< metres: beyond it a slip of the unit is likelier than a wish

/// What most voxels of a ball about each voxel are. Balls that reach beyond the volume count what is inside.
Cancellable<std::vector<Label>> commonest(const Block& block, const Eigen::Vector3d& spacing_mm,
                                          double radius_mm, const RunContext& context) {
  const std::vector<BallRow> ball = ball_rows(spacing_mm, radius_mm);
  const Quiet quiet(block, spacing_mm, radius_mm);
  Votes votes(block, ball);
  std::vector<Label> result = block.labels;
  const Eigen::Vector3i size = block.box.size();
  for (int k = 0; k < size.z(); ++k) {
    if (context.cancelled()) return std::nullopt;
    context.progress(static_cast<double>(k) / size.z(), "segmentation.edit");
    for (int j = 0; j < size.y(); ++j) {
      votes.start_row(j, k);
      for (int i = 0; i < size.x(); ++i) {
        const std::size_t at = block.offset(i, j, k);
        if (quiet.at(i, j, k)) continue;
        votes.move_to(i);
        result[at] = votes.winner(block.labels[at]);
      }
    }
  }
  return result;
}

/// All labels at once: nothing is left between them, as each voxel goes to one of them.
Cancellable<Canvas> smooth_all(const Smooth& tool, Task& task) {
  LabelSet any;
  for (int label = 1; label <= structure::kLastLesion; ++label) any.insert(static_cast<Label>(label));
  const double radius_mm = 1e3 * tool.radius;
  // Twice the radius: the balls about the voxels that can change are read whole.
  const VoxelBox box = grown(box_of(task.labels.voxels, any), task.grid(), 2.0 * radius_mm);
  Canvas canvas = task.canvas(box);
  if (box.empty()) return canvas;
  const Block block{box, labels_in(task.labels.voxels, box)};
  const auto after = smoothed_jointly(
      block, task.grid().spacing_mm, radius_mm,
      [&](int i, int j, int k, Label from, Label to) {
        return canvas.gate().open(i + box.low.x(), j + box.low.y(), k + box.low.z(), from, to);
      },
      task.context.part(0.0, 0.9));
  if (!after) return std::nullopt;
  const bool done = canvas.rewrite(box, task.context.part(0.9, 1.0), [&](int i, int j, int k, Label) {
    return (*after)[block.offset(i - box.low.x(), j - box.low.y(), k - box.low.z())];
  });
  if (!done) return std::nullopt;
  return canvas;
}

Cancellable<Mask> majority(const Mask& mask, const VoxelBox& box, double radius_mm,
                           const RunContext& context) {
  const Block block{box, std::vector<Label>(mask.voxels.begin(), mask.voxels.end())};
  const auto winners = commonest(block, mask.spacing_mm, radius_mm, context);
  if (!winners) return std::nullopt;
  Mask result(mask.size, mask.spacing_mm);
  std::copy(winners->begin(), winners->end(), result.voxels.begin());
  return result;
}

Cancellable<Canvas> apply(const Smooth& tool, Task& task) {
  if (tool.method == Smooth::Method::joint) return smooth_all(tool, task);
  const double radius_mm = 1e3 * tool.radius;
  const LabelSet shape = shape_of(tool.label);
  // What a median adds must end inside the box, and a voxel of air lie about it.
  const VoxelBox box = grown(box_of(task.labels.voxels, shape), task.grid(),
                             2.0 * radius_mm + task.grid().spacing_mm.maxCoeff());
  Canvas canvas = task.canvas(box);
  if (box.empty()) return canvas;
  const Mask mask = mask_in(task.labels.voxels, box, shape);
  Cancellable<Mask> after;
  if (tool.method == Smooth::Method::median) {
    after = majority(mask, box, radius_mm, task.context.part(0.0, 0.8));
  } else {
    after = tool.method == Smooth::Method::closing ? closed(mask, radius_mm) : opened(mask, radius_mm);
    task.context.progress(0.8, "segmentation.edit");
    if (task.context.cancelled()) return std::nullopt;
  }
  if (!after || !reshape(canvas, box, *after, tool.label, task.context.part(0.8, 1.0))) return std::nullopt;
  return canvas;
}

using Method = Smooth::Method;

const Names<Method>& methods() {
  static const Names<Method> kNames = {{"median", Method::median},
                                       {"closing", Method::closing},
                                       {"opening", Method::opening},
                                       {"joint", Method::joint}};
  return kNames;
}

bool has_label(const Smooth& t) { return t.method != Method::joint; }

Description<Smooth> description() {
  return {"smooth",
          80,
          {choice_field("method", &Smooth::method, methods()),
           label_field("label", &Smooth::label)
               .needed("but for `joint`", has_label)
               .checked([](const SettingsCheck& check, const Smooth& t) {
                 if (has_label(t)) check.target(t.label, "label");
               }),
           length_field("radius_mm", &Smooth::radius, kLargest)},
          steps_of("smooth", methods()),
          [](const Smooth& t) {
            return StepName{"smooth." + name_of(methods(), t.method),
                            has_label(t) ? t.label : structure::kBackground, t.radius};
          },
          apply};
}

}  // namespace

const ToolKind& Smooth::kind() {
  static const Described<Smooth> kKind(description());
  return kKind;
}
const ToolKind& smooth_tool() { return Smooth::kind(); }

}  // namespace glisson::editing
