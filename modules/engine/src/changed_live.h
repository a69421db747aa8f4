// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/engine/command.h"
#include "glisson/engine/parts/live.h"

namespace glisson::engine {

/// Of what hands say while the organ is followed: on the lane that has the follower.
inline CommandTraits correction_traits(std::string_view code) {
  return {.code = code,
          .reads = {part::live},
          .writes = {part::live},
          .needs = {part::live},
          .current = {part::live},
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

/// @throws InputError nothing is followed.
inline Follower& follower_of(const Services& services) {
  if (!services.follower)
    throw InputError("correction", "the organ", "is not followed", "Start tracking first");
  return *services.follower;
}

/// The live part as it is now, with what hands have said. The follower has changed already: who cancels now
/// comes too late, or the case would tell of another registration than the one that is followed.
inline Applied with_live(const CaseState& state, OverlayFrame overlay, const Follower& follower) {
  Applied applied{state};
  LiveState live = *state[part::live];
  live.overlay = std::move(overlay);
  live.corrections = follower.corrections();
  live.mask = follower.mask_status();
  applied.figures["corrections"] = static_cast<double>(live.corrections.size());
  applied.state[part::live] = std::make_shared<const LiveState>(std::move(live));
  applied.is_final = true;
  return applied;
}

}  // namespace glisson::engine
