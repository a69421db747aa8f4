// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/atlas/atlas.h"
#include "glisson/atlas/transfer.h"
#include "glisson/core/run_context.h"

namespace glisson::experiments {

/// What an atlas that the liver had no part in proposes from its surface (and what else is known of it),
/// against its structures: the built atlas' LeftOut, without what only its building tells (turned_deg,
/// misfits, folded). Empty: cancelled.
/// @throws InputError as atlas::transfer().
Cancellable<atlas::LeftOut> foretold(const atlas::Atlas& atlas, const atlas::Member& member,
                                     const RunContext& context, const atlas::Evidence& evidence = {});

}  // namespace glisson::experiments
