// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glisson/engine/command.h"

namespace glisson::engine {

/// Gives a kept moment another title; empty: none.
/// @throws InputError there is none of this number.
struct RenameMoment {
  int number = 0;
  std::string title;  ///< at most 200 letters

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
