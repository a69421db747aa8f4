// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/case_state.h"

#include <algorithm>

namespace glisson::engine {

const void* CaseState::address(Part part) const {
  const auto slot = slots_.find(part);
  return slot == slots_.end() ? nullptr : part.type().value_in(slot->second.value);
}

const Stamp& CaseState::stamp(Part part) const {
  static const Stamp kNone;
  const auto slot = slots_.find(part);
  return slot == slots_.end() ? kNone : slot->second.stamp;
}

void CaseState::take_value(Part part, const CaseState& from) {
  const auto slot = from.slots_.find(part);
  slots_[part].value = slot == from.slots_.end() ? std::any() : slot->second.value;
}

void CaseState::take(Part part, const CaseState& from) {
  take_value(part, from);
  for (const PartType* companion : part.type().spec().companions) take_value(*companion, from);
}

Editions editions(const CaseState& state) {
  Editions all;
  for (const Part part : all_parts())
    if (part.type().is_saved()) all[part] = state.stamp(part).revision;
  return all;
}

StageState stage_state(const CaseState& state, Part part) {
  if (!state.has(part)) return StageState::absent;
  const auto& made_from = state.stamp(part).made_from;
  const bool stale = std::any_of(made_from.begin(), made_from.end(), [&](const auto& input) {
    return state.stamp(input.first).revision != input.second ||
           stage_state(state, input.first) == StageState::stale;
  });
  return stale ? StageState::stale : StageState::current;
}

}  // namespace glisson::engine
