// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/redo_labels.h"

#include "glisson/engine/parts/image.h"
#include "label_steps.h"

namespace glisson::engine {

CommandTraits RedoLabels::traits() const {
  return {.code = "redo_labels",
          .reads = labels_and_review() | Parts{part::image},
          .writes = labels_and_review(),
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> RedoLabels::apply(const CaseState& state, const RunContext&) const {
  Applied applied{state};
  step_labels(applied.state, StepDirection::forth);
  return applied;
}

}  // namespace glisson::engine
