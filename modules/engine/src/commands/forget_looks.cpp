// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/forget_looks.h"

#include "glisson/engine/parts/earlier_looks.h"

namespace glisson::engine {

CommandTraits ForgetLooks::traits() const {
  return {.code = "forget_looks",
          .reads = {part::earlier_looks},
          .writes = {part::earlier_looks},
          .needs = {part::earlier_looks}};
}

Cancellable<Applied> ForgetLooks::apply(const CaseState& state, const RunContext&) const {
  Applied applied{state};
  applied.state[part::earlier_looks] = nullptr;
  return applied;
}

}  // namespace glisson::engine
