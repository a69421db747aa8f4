// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/edit_trees.h"

#include "glisson/engine/parts/model.h"
#include "model_figures.h"
#include "seen.h"

namespace glisson::engine {

CommandTraits EditTrees::traits() const {
  return {.code = "edit_trees",
          .reads = {part::model},
          .writes = {part::model},
          .needs = {part::model},
          .lane = Lane::edits};
}

Cancellable<Applied> EditTrees::apply(const CaseState& state, const RunContext&) const {
  require_seen(state, part::model, seen);
  return with_model(state, model::with_tree_edits(*state[part::model], edits));
}

}  // namespace glisson::engine
