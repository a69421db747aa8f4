// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/check_model.h"

#include "glisson/engine/parts/model.h"
#include "seen.h"

namespace glisson::engine {

CommandTraits CheckModel::traits() const {
  return {.code = "check_model",
          .reads = {part::model},
          .writes = {part::check},
          .needs = {part::model},
          .lane = Lane::edits};
}

Cancellable<Applied> CheckModel::apply(const CaseState& state, const RunContext&) const {
  require_seen(state, part::model, seen);
  Applied applied{state};
  applied.state[part::check] = std::make_shared<const ModelCheck>(check);
  return applied;
}

}  // namespace glisson::engine
