// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/atlas/transfer.h"
#include "glisson/geometry/closest_point_tree.h"

namespace glisson::atlas {

/// As the public one. @param liver its surface
void propose_again(Transfer& transfer, const ClosestPointTree& liver, const Evidence& evidence);

/// Moves a proposal's points to the closest ones of the surface.
void onto_liver(Proposal& proposal, const ClosestPointTree& liver);

}  // namespace glisson::atlas
