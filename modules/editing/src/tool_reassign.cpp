// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/reassign.h"

#include "describe.h"
#include "edit_shape.h"
#include "glisson/core/error.h"
#include "glisson/editing/bridges.h"

namespace glisson::editing {
namespace {

/// A branch that is cut off leaves no hole in the liver: its voxels become the nearer one of parenchyma and
/// background. False when cancelled.
bool cut_off(Canvas& canvas, const LabelVolume& wanted, Label label, const RunContext& context) {
  const LabelVolume& before = canvas.before().voxels;
  const VoxelBox box = grown(box_of(before, {label}), before.grid(), before.grid().spacing_mm.maxCoeff());
  Mask stays = mask_in(wanted, box, {label});
  return reshape(canvas, box, stays, label, context);
}

Cancellable<Canvas> apply(const ReassignBranch& tool, Task& task) {
  constexpr const char* kName = "reassign_branch";
  voxel_at(task.grid(), tool.p_in_ct, kName);  // refuses a click beside the volume
  const LabelVolume& before = task.labels.voxels;
  LabelVolume wanted;
  try {
    wanted = reassign_branch(before, tool.label, tool.to, Point<CtFrame>(tool.p_in_ct));
  } catch (const InputError& error) {
    throw InputError(kName, "p_in_ct", error.problem(), error.remedy());
  }
  Canvas canvas = task.canvas(whole_box(task.grid()));
  if (tool.to == structure::kBackground) {
    if (!cut_off(canvas, wanted, tool.label, task.context)) return std::nullopt;
    return canvas;
  }
  for (const LabelChange& change : wanted.changes_since(before)) {
    const Eigen::Vector3i low = LabelVolume::kSide * before.brick_place(change.number);
    const VoxelBox part =
        intersection({low, (low.array() + LabelVolume::kSide).matrix()}, whole_box(task.grid()));
    canvas.rewrite_part(change.number, part, [&](int i, int j, int k, Label) {
      return change.after ? (*change.after)[in_brick(i, j, k)] : structure::kBackground;
    });
  }
  return canvas;
}

Description<ReassignBranch> description() {
  return {"reassign_branch",
          120,
          {label_field("label", &ReassignBranch::label),
           label_field("to", &ReassignBranch::to)
               .checked([](const SettingsCheck& check, const ReassignBranch& t) {
                 check.target(t.to, "to", true);
                 if (t.to == t.label)
                   check.refuse("to", "is the label that the branch has", "Choose another one");
               }),
           point_field(&ReassignBranch::p_in_ct)},
          {"reassign_branch", "reassign_branch.cut"},
          [](const ReassignBranch& t) {
            return StepName{t.to == structure::kBackground ? "reassign_branch.cut" : "reassign_branch",
                            t.label, 0.0};
          },
          apply,
          [](const ReassignBranch&) { return true; }};
}

}  // namespace

const ToolKind& ReassignBranch::kind() {
  static const Described<ReassignBranch> kKind(description());
  return kKind;
}
const ToolKind& reassign_tool() { return ReassignBranch::kind(); }

}  // namespace glisson::editing
