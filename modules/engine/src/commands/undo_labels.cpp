// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/undo_labels.h"

#include "glisson/engine/parts/image.h"
#include "label_steps.h"

namespace glisson::engine {

CommandTraits UndoLabels::traits() const {
  return {.code = "undo_labels",
          .reads = labels_and_review() | Parts{part::image},
          .writes = labels_and_review(),
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> UndoLabels::apply(const CaseState& state, const RunContext&) const {
  Applied applied{state};
  step_labels(applied.state, StepDirection::back);
  return applied;
}

}  // namespace glisson::engine
