// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "glisson/engine/command.h"
#include "glisson/engine/engine.h"

namespace glisson::engine {

/// A command on its way.
struct Job {
  CommandId id = 0;
  Command command;
  std::shared_ptr<CancelFlag> cancel;
  std::optional<std::uint64_t> case_number = {};  ///< of the case that it is meant for; nothing: of any

  const CommandTraits& traits() const { return command.traits(); }
  bool is_meant_for(std::uint64_t number) const {
    return traits().replaces_case() || !case_number || *case_number == number;
  }
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
