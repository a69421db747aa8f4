// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/engine/command.h"
#include "glisson/engine/engine.h"

namespace glisson::engine {

/// A command on its way.
struct Job {
  CommandId id = 0;
  Command command;
  std::shared_ptr<CancelFlag> cancel;

  const CommandTraits& traits() const { return command.traits(); }
  /// Whether the outcome depends on which of the two is done first.
  bool conflicts_with(const Job& other) const {
    return must_wait_for(other) || traits().writes.meets(other.traits().reads);
  }
  /// Whether this must wait for `running`, which was posted before. A running command took its inputs at its
  /// start, so only its writes matter: an edit of the labels need not wait until a model is built of them.
  /// Starts and stops of one live lane write no part, but keep their order.
  bool must_wait_for(const Job& running) const {
    const bool same_lane = traits().live != LiveLane::none && traits().live == running.traits().live;
    return same_lane || running.traits().writes.meets(traits().reads | traits().writes);
  }
};

}  // namespace glisson::engine
