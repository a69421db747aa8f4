// SPDX-License-Identifier: GPL-3.0-or-later
#include "outcome_store.h"

#include <algorithm>
#include <utility>

namespace glisson::engine {

void OutcomeStore::add(Outcome outcome) {
  const CommandId id = outcome.id;
  ended_.push_back(id);
  outcomes_.emplace(id, std::move(outcome));
  for (std::size_t i = 0; i + kResultsKept < ended_.size(); ++i)
    if (!is_wanted(ended_[i])) outcomes_.at(ended_[i]).result = {};
  if (ended_.size() <= kKept) return;
  const auto oldest =
      std::find_if(ended_.begin(), ended_.end(), [this](CommandId other) { return !is_wanted(other); });
  if (oldest == ended_.end()) return;
  outcomes_.erase(*oldest);
  ended_.erase(oldest);
}

const Outcome* OutcomeStore::find(CommandId id) const {
  const auto found = outcomes_.find(id);
  return found == outcomes_.end() ? nullptr : &found->second;
}

}  // namespace glisson::engine
