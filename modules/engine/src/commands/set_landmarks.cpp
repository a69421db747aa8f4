// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/set_landmarks.h"

#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "seen.h"

namespace glisson::engine {

CommandTraits SetLandmarks::traits() const {
  return {.code = "set_landmarks",
          .reads = {part::model},
          .writes = {part::landmarks},
          .needs = {part::model},
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> SetLandmarks::apply(const CaseState& state, const RunContext&) const {
  require_seen(state, part::model, seen);
  Applied applied{state};
  // None at all is as if nobody had said anything: a part that holds nothing could not be saved.
  const bool none = landmarks.empty() && landmarks.vena_cava.rows() == 0;
  applied.state[part::landmarks] = none ? nullptr : std::make_shared<const Landmarks>(landmarks);
  return applied;
}

}  // namespace glisson::engine
