// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/set_seeds.h"

#include "glisson/engine/parts/seeds.h"

namespace glisson::engine {

CommandTraits SetSeeds::traits() const {
  return {.code = "set_seeds", .writes = {part::seeds}, .lane = Lane::edits, .notice = Notice::quiet};
}

Cancellable<Applied> SetSeeds::apply(const CaseState& state, const RunContext&) const {
  Applied applied{state};
  applied.state[part::seeds] = std::make_shared<const segmentation::Seeds>(seeds);
  return applied;
}

}  // namespace glisson::engine
