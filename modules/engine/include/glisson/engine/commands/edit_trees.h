// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/engine/command.h"
#include "glisson/model/tree_edits.h"

namespace glisson::engine {

/// Replays edits on the trees as they were built; undo is the list without its last.
struct EditTrees {
  std::vector<model::TreeEdit> edits;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
