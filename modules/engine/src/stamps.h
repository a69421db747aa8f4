// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "glisson/engine/command.h"

namespace glisson::engine {

/// Takes over what a command made: the parts that it writes and has changed, each as a new edition that knows
/// of which editions of others it was made. What was made of a part is still made of it when the command
/// changed both.
/// @param state as it is now: its other parts may have moved on since the command began.
/// @param base from which the command began. @param revision the last one given; goes on from there.
void take_over(CaseState& state, const CommandTraits& command, const CaseState& base, const CaseState& made,
               std::uint64_t& revision);

}  // namespace glisson::engine
