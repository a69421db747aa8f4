// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "glisson/engine/command.h"
#include "glisson/engine/parts/moments.h"

namespace glisson::engine {

/// More would make a case slow to save, and nobody finds one among them.
inline constexpr std::size_t kMostMoments = 200;
/// Of all moments' pictures together, bytes: they are in memory while the case is open.
inline constexpr std::size_t kMostMomentBytes = std::size_t{1} << 30U;

/// Keeps a moment of the live view in the case, with the next number, or again under its own after it was
/// deleted. Figure: `moment`, its number.
/// @pre both pictures, and a pose where there are nodes. @throws InputError as many are kept as can be, or
/// this one is.
struct KeepMoment {
  std::shared_ptr<const KeptMoment> moment;  ///< never null

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
