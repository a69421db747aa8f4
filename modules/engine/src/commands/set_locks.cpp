// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/set_locks.h"

#include "glisson/engine/parts/locks.h"

namespace glisson::engine {

CommandTraits SetLocks::traits() const {
  return {.code = "set_locks", .writes = {part::locks}, .lane = Lane::edits, .notice = Notice::quiet};
}

Cancellable<Applied> SetLocks::apply(const CaseState& state, const RunContext&) const {
  Applied applied{state};
  applied.state[part::locks] = std::make_shared<const std::set<Label>>(locked);
  return applied;
}

}  // namespace glisson::engine
