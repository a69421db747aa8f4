// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <set>

#include "glisson/engine/engine.h"

namespace glisson::engine {

/// Outcomes of commands that have ended. One that nobody waits for is kept so long that a late wait() still
/// finds it, but not for ever; its result, which may be as large as a scan, for less long. Not thread-safe.
class OutcomeStore {
 public:
  static constexpr std::size_t kKept = 1024, kResultsKept = 4;

  /// While it lives the outcome of a command stays once it has come, and its result.
  class Wanted {
   public:
    Wanted(OutcomeStore& store, CommandId id) : store_(store), mine_(store.wanted_.insert(id)) {}
    ~Wanted() { store_.wanted_.erase(mine_); }
    Wanted(const Wanted&) = delete;
    Wanted& operator=(const Wanted&) = delete;

   private:
    OutcomeStore& store_;
    std::multiset<CommandId>::iterator mine_;
  };

  void add(Outcome outcome);
  /// Null: it has not ended, or that was long ago.
  const Outcome* find(CommandId id) const;

 private:
  bool is_wanted(CommandId id) const { return wanted_.contains(id); }

  std::map<CommandId, Outcome> outcomes_;
  std::deque<CommandId> ended_;  ///< in the order in which they came
  std::multiset<CommandId> wanted_;
};

}  // namespace glisson::engine
