// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>

namespace glisson {

/// How an iteration ended, the same words for every solver that reports it. Cancel is none of them: it leaves
/// a Cancellable empty.
enum class Termination {
  converged,   ///< the tolerance was reached
  step_limit,  ///< all allowed steps were done, none of them bad: the result may be used with that doubt
  diverged,    ///< no longer finite, or no step leads on: not to be trusted
  stalled      ///< it gained nothing any more, short of the tolerance: to and fro, say
};
inline constexpr std::array<std::pair<Termination, const char*>, 4> kTerminations = {
    {{Termination::converged, "converged"},
     {Termination::step_limit, "limit_reached"},
     {Termination::diverged, "diverged"},
     {Termination::stalled, "stalled"}}};

/// For files and figures.
inline const char* termination_code(Termination termination) {
  for (const auto& [one, code] : kTerminations)
    if (one == termination) return code;
  return "unknown";
}

}  // namespace glisson
