// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/atlas/atlas.h"
#include "glisson/atlas/transfer.h"
#include "glisson/core/run_context.h"

namespace glisson::experiments {

/// What is proposed on a liver, against its structures: the built atlas' LeftOut, without what only its
/// building tells (turned_deg, misfits, folded, with_notch).
atlas::LeftOut judged(const atlas::Transfer& made, const atlas::Member& member);

/// The same of what an atlas that the liver had no part in proposes from its surface. Empty: cancelled.
/// @throws InputError as atlas::transfer().
Cancellable<atlas::LeftOut> foretold(const atlas::Atlas& atlas, const atlas::Member& member,
                                     const RunContext& context);

}  // namespace glisson::experiments
