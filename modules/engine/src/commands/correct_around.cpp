// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/correct_around.h"

#include <algorithm>
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
  const LabelMap& before = *state[part::labels];
  LabelMap labels = before;
  Applied applied{state};
  long changed = 0;
  double reach_mm = 0.0;
  const auto count = static_cast<double>(clicks.size());
  for (std::size_t n = 0; n < clicks.size(); ++n) {
    const auto at = static_cast<double>(n);
    auto corrected = segmentation::correct_around(*state[part::image], labels, seeds, clicks[n], locked,
                                                  context.part(at / count, (at + 1.0) / count));
    if (!corrected) return {};
    labels = std::move(corrected->labels);
    changed += corrected->voxels_changed;
    reach_mm = std::max(reach_mm, corrected->reach_mm);
    applied.notes.insert(applied.notes.end(), corrected->notes.begin(), corrected->notes.end());
  }
  applied.figures["voxels_changed"] = static_cast<double>(changed);
  applied.figures["changed_ml"] =
      1e-3 * static_cast<double>(changed) * labels.voxels.grid().voxel_volume_mm3();
  applied.figures["reach_mm"] = reach_mm;
  // Where nothing changes the labels stay the same edition: a model made of them is not out of date.
  if (changed > 0)
    put_edited_labels(applied.state, before, std::move(labels),
                      {"correct_around", structure::kParenchyma, 0.0}, 0);
  if (applied.state[part::statistics]) report_labels(applied.state, applied.figures);
  return applied;
}

}  // namespace glisson::engine
