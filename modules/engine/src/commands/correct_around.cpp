// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/correct_around.h"

#include <utility>

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "label_steps.h"

namespace glisson::engine {

CommandTraits CorrectAround::traits() const {
  return {.code = "correct_around",
          .reads = labels_and_review() | Parts{part::image},
          .writes = labels_and_review(),
          .needs = {part::image, part::labels},
          .notice = Notice::quiet};
}

Cancellable<Applied> CorrectAround::apply(const CaseState& state, const RunContext& context) const {
  require_labels_fit_image(state);
  const auto before = state[part::labels];
  auto corrected = segmentation::correct_around(*state[part::image], *before, seeds, click, locked, context);
  if (!corrected) return {};
  Applied applied{state};
  applied.figures["voxels_changed"] = static_cast<double>(corrected->voxels_changed);
  applied.figures["changed_ml"] =
      1e-3 * static_cast<double>(corrected->voxels_changed) * before->voxels.grid().voxel_volume_mm3();
  applied.figures["reach_mm"] = corrected->reach_mm;
  applied.notes = std::move(corrected->notes);
  // Where nothing changes the labels stay the same edition: a model made of them is not out of date.
  if (corrected->voxels_changed > 0)
    put_edited_labels(applied.state, *before, std::move(corrected->labels),
                      {"correct_around", structure::kParenchyma, 0.0}, 0);
  if (applied.state[part::statistics]) report_labels(applied.state, applied.figures);
  return applied;
}

}  // namespace glisson::engine
