// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "anatomy.h"

namespace glisson::model {

/// Masks to beams: pieces, roots, skeletons, curves, nodes. One tree a root; every piece that is left out and
/// every branch that is pruned is in the notes.
/// @throws InputError a root point far from its vessel.
Cancellable<std::vector<VesselTree>> vessel_trees(const Anatomy& anatomy, const ModelOptions& options,
                                                  std::vector<std::string>& notes, const RunContext& context);

}  // namespace glisson::model
