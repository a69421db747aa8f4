// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/obstacle.h"

#include <algorithm>
#include <string>

#include "glisson/engine/command.h"
#include "glisson/engine/engine.h"

namespace glisson::engine {
namespace {

bool is_stale(const CaseState& state, Part part) { return stage_state(state, part) == StageState::stale; }

/// What of a part's inputs is missing, first in the stage graph's order.
std::optional<Part> missing_input(const CaseState& state, Part part) {
  const auto& inputs = part.type().spec().made_of;
  const auto first =
      std::find_if(inputs.begin(), inputs.end(), [&](Part input) { return !state.has(input); });
  return first == inputs.end() ? std::nullopt : std::optional(*first);
}

/// Where a stale part's being out of date begins.
Obstacle origin(const CaseState& state, Part part) {
  const auto& made_from = state.stamp(part).made_from;
  for (const Part input : all_parts())
    if (input != part && made_from.contains(input) && is_stale(state, input)) return origin(state, input);
  for (const Part input : all_parts()) {
    const auto then = made_from.find(input);
    if (then != made_from.end() && then->second != state.stamp(input).revision)
      return {Obstacle::Kind::stale, part, input};
  }
  return {Obstacle::Kind::stale, part, std::nullopt};
}

/// The first part that a command would change below what goes on from it (PartSpec::follows).
std::optional<Part> written_below(const CaseState& state, const Parts& writes) {
  for (const Part part : all_parts()) {
    if (!state.has(part) || writes.has(part)) continue;
    for (const Part followed : part.type().spec().follows)
      if (writes.has(followed)) return followed;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Obstacle> obstacle(const CaseState& state, const Needs& needs, const Parts& current,
                                 const Parts& accepted) {
  for (const Need& need : needs)
    if (!state.has(need.part) && !state.has(need.instead))
      return Obstacle{Obstacle::Kind::missing, need.part, missing_input(state, need.part)};
  for (const Part part : all_parts())
    if (current.has(part) && is_stale(state, part)) return origin(state, part);
  for (const Part part : all_parts())
    if (accepted.has(part) && is_refused(state, part))
      return Obstacle{Obstacle::Kind::refused, part, std::nullopt};
  return std::nullopt;
}

bool is_refused(const CaseState& state, Part part) {
  const auto& of_type = part.type().spec().is_refused;
  return of_type && state.has(part) && of_type(state);
}

std::optional<Obstacle> obstacle(const CaseState& state, const Command& command) {
  const CommandTraits& traits = command.traits();
  const auto first = obstacle(state, traits.needs, traits.current, traits.accepted);
  if (first) return first;
  if (const auto followed = written_below(state, traits.writes))
    return Obstacle{Obstacle::Kind::followed, *followed, std::nullopt};
  return std::nullopt;
}

std::optional<Obstacle> obstacle(const Snapshot& snapshot, const Command& command) {
  return obstacle(snapshot.state, command);
}

InputError error_of(const Obstacle& obstacle) {
  const std::string code(obstacle.part.code());
  const std::string remedy(obstacle.part.type().spec().remedy);
  if (obstacle.kind == Obstacle::Kind::missing) return {"case", code, "there is none yet", remedy};
  if (obstacle.kind == Obstacle::Kind::refused)
    return {"case", code, "was refused: what is known contradicts it",
            std::string(obstacle.part.type().spec().refused_remedy)};
  if (obstacle.kind == Obstacle::Kind::followed)
    return {"case", code, "is what the organ is followed from just now", "Stop tracking first"};
  const std::string cause =
      obstacle.input ? ": its " + std::string(obstacle.input->code()) + " changed since it was made" : "";
  return {"case", code, "is out of date" + cause, "Make it anew"};
}

void require_parts(const CaseState& state, const Needs& needs) {
  if (const auto first = obstacle(state, needs)) throw error_of(*first);
}

}  // namespace glisson::engine
