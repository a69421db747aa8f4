// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/engine/case_state.h"

namespace glisson::engine {

class Command;
struct Snapshot;

/// Why something cannot be done now, and what comes first. Panels, menus and the command line translate it.
struct Obstacle {
  enum class Kind {
    missing,  ///< `part` is not there
    stale,    ///< `part` is out of date and has to be made anew
    refused,  ///< `part` contradicts what is known, and nobody has accepted it
    followed  ///< the organ is followed from `part`, which the follower would not learn of: stop first
  };
  Kind kind = Kind::missing;
  Part part;
  /// Of a stale part: what has changed since it was made. Of a missing one: what it is made of and what is
  /// not there either. Empty: nothing.
  std::optional<Part> input;
  bool operator==(const Obstacle&) const = default;
};

/// The first of `needs` that is not there; else the first of `current` that is out of date, followed back to
/// where that begins: made again of an input that is itself out of date, a part would be so as before. Else
/// the first of `accepted` that stands refused.
std::optional<Obstacle> obstacle(const CaseState& state, const Needs& needs, const Parts& current = {},
                                 const Parts& accepted = {});
/// What stands in the way of a command, by its traits; last, that it would put another registration below
/// what is followed (CommandTraits::writes has it, but not the live part).
std::optional<Obstacle> obstacle(const CaseState& state, const Command& command);
std::optional<Obstacle> obstacle(const Snapshot& snapshot, const Command& command);

/// Whether a part contradicts what is known and nobody has accepted it.
bool is_refused(const CaseState& state, Part part);

/// The same as an error: "case: labels: there is none yet. Segment the CT or import labels first."
InputError error_of(const Obstacle& obstacle);
/// For what is done with a case's parts outside commands. @throws InputError error_of() the first that is
/// missing.
void require_parts(const CaseState& state, const Needs& needs);

}  // namespace glisson::engine
