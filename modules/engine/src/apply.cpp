// SPDX-License-Identifier: GPL-3.0-or-later
// One command on one state, without threads: what every runner does.
#include "glisson/engine/engine.h"
#include "glisson/engine/obstacle.h"

namespace glisson::engine {

Services plain_services() { return {make_follower, make_load_trial, {}, {}}; }

Cancellable<Applied> apply(const CaseState& state, const Command& command, const RunContext& context,
                           const Services& services) {
  if (const auto first = obstacle(state, command)) throw error_of(*first);
  return command.apply(state, context, services);
}

}  // namespace glisson::engine
