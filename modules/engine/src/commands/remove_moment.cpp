// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/remove_moment.h"

#include <string>

#include "glisson/core/error.h"
#include "glisson/engine/parts/moments.h"

namespace glisson::engine {

CommandTraits RemoveMoment::traits() const {
  return {.code = "remove_moment",
          .reads = {part::moments},
          .writes = {part::moments},
          .needs = {part::moments},
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> RemoveMoment::apply(const CaseState& state, const RunContext&) const {
  KeptMoments kept = *state[part::moments];
  const auto is_it = [this](const auto& one) { return one->number == number; };
  if (std::erase_if(kept.moments, is_it) == 0)
    throw InputError("moments", "moment " + std::to_string(number), "is not kept", "Choose one of the list");
  Applied applied{state};
  applied.state[part::moments] =
      kept.moments.empty() ? nullptr : std::make_shared<const KeptMoments>(std::move(kept));
  return applied;
}

}  // namespace glisson::engine
