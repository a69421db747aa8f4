// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
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
  bool conflicts_with(const Job& other) const {
    return must_wait_for(other) || traits().writes.meets(other.traits().reads);
  }
  /// Whether this cannot start while `running`, which was posted before, is running: what that reads it has
  /// taken when it began, so only what it writes matters. An edit of the labels need not wait until a model
  /// is built of them. Starts and stops of one live lane touch no part, but keep their order.
  bool must_wait_for(const Job& running) const {
    const bool same_lane = traits().live != LiveLane::none && traits().live == running.traits().live;
    return same_lane || running.traits().writes.meets(traits().reads | traits().writes);
  }
};

/// Of which editions of other parts a part was made that a command wrote.
inline std::map<Part, std::uint64_t> made_from(Part part, const CommandTraits& command,
                                               const CaseState& base) {
  std::map<Part, std::uint64_t> inputs;
  const PartSpec& spec = part.type().spec();
  if (spec.stands_alone) return inputs;
  if (command.reads.has(part)) {
    // What is only changed stays as old as it was: an edit does not make labels of a former CT current, nor a
    // model of former labels.
    inputs = base.stamp(part).made_from;
    for (const Part freed : spec.changed_frees_from) inputs.erase(freed);
  }
  for (const Part input : all_parts()) {
    if (input == part || !input.type().spec().is_input || !command.reads.has(input)) continue;
    // An input that was not there counts too (revision 0): when it comes, this part is stale.
    inputs.try_emplace(input, base.stamp(input).revision);
  }
  return inputs;
}

}  // namespace glisson::engine
