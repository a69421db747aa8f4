// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "glisson/engine/commands.h"
#include "glisson/engine/engine.h"

namespace glisson::engine {

/// The engine's two threads: short edits (and everything live) on the one, long work on the other.
enum class Lane { edits, work };

/// A command on its way.
struct Job {
  CommandId id = 0;
  Command command;
  std::shared_ptr<CancelFlag> cancel;

  Lane lane() const { return is_edit(command) ? Lane::edits : Lane::work; }
  /// Starts and stops of a trial touch no part, but keep their order.
  bool is_about_trial() const {
    return std::holds_alternative<StartTrial>(command) || std::holds_alternative<StopTrial>(command);
  }
  bool conflicts_with(const Job& other) const {
    return must_wait_for(other) || writes(command).meets(reads(other.command));
  }
  /// Whether this cannot start while `other`, which was posted before, is running: what that reads it has
  /// taken when it began, so only what it writes matters. An edit of the labels need not wait until a model
  /// is built of them.
  bool must_wait_for(const Job& running) const {
    return (is_about_trial() && running.is_about_trial()) ||
           writes(running.command).meets(reads(command) | writes(command));
  }
};

/// Of which editions of other parts a part was made that a command wrote.
inline std::map<Part, std::uint64_t> made_from(Part part, const Command& command, const CaseState& base) {
  std::map<Part, std::uint64_t> inputs;
  if (part == Part::review) return inputs;  // a person's word, made from nothing
  if (reads(command).has(part)) {
    // What is only changed stays as old as it was: an edit does not make labels of a former CT current, nor a
    // model of former labels. But labels that a hand has changed no longer follow from seeds alone.
    inputs = base.stamp(part).made_from;
    inputs.erase(Part::seeds);
  }
  for (int k = 0; k < kPartCount; ++k) {
    const Part input = static_cast<Part>(k);
    if (input == part || input == Part::review || input == Part::preview || !reads(command).has(input))
      continue;
    // An input that was not there counts too (revision 0): when it comes, this part is stale.
    inputs.try_emplace(input, base.stamp(input).revision);
  }
  return inputs;
}

}  // namespace glisson::engine
