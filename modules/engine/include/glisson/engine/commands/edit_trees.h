// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/engine/command.h"
#include "glisson/model/build.h"
#include "glisson/model/tree_edits.h"

namespace glisson::engine {

/// Replays edits on the trees as they were built; undo is the list without its last.
struct EditTrees {
  std::vector<model::TreeEdit> edits;
  /// The model whose trees the person has looked at; null: whatever the case holds.
  std::shared_ptr<const model::BuiltModel> seen = {};

  CommandTraits traits() const;
  /// @throws InputError `seen` is not what the case holds.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
