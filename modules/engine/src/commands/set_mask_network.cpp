// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/set_mask_network.h"

#include "changed_live.h"

namespace glisson::engine {

CommandTraits SetMaskNetwork::traits() const { return correction_traits("set_mask_network"); }

Cancellable<Applied> SetMaskNetwork::apply(const CaseState& state, const RunContext&,
                                           const Services& services) const {
  Follower& follower = follower_of(services);
  follower.set_mask_network(network);
  Applied applied = with_live(state, state[part::live]->overlay, follower);
  return applied;
}

}  // namespace glisson::engine
