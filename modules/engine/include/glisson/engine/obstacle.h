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

/// What stands in the way, in this order: the first of `needs` that is not there; the first of `current` that
/// is out of date; the first of `accepted` that stands refused. A part that is out of date because its inputs
/// are is traced back to the first of them: that one has to be made anew before it.
std::optional<Obstacle> obstacle(const CaseState& state, const Needs& needs, const Parts& current = {},
                                 const Parts& accepted = {});
/// What stands in the way of a command, by its traits. After the above: it would change a part below what
/// goes on from it (PartSpec::follows), as the registration from which the organ is followed.
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
