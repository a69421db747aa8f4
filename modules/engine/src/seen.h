// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "glisson/core/error.h"
#include "glisson/engine/case_state.h"

namespace glisson::engine {

/// The rule for every command by which a person says something of a part that this person has looked at: a
/// result that came between the look and the command is not what was looked at.
/// @param seen what was looked at; null: whatever the case holds, as a script means it.
/// @throws InputError the case holds another one.
template <class T>
void require_seen(const CaseState& state, const PartOf<T>& part, const std::shared_ptr<const T>& seen) {
  if (seen && seen != state[part])
    throw InputError("case", std::string(Part(part).code()), "has changed since it was looked at",
                     "Look at it as it is now, and say it again");
}

}  // namespace glisson::engine
