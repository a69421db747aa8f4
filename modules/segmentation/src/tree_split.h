// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field.h"
#include "glisson/core/run_context.h"

namespace glisson::segmentation {

/// Whose a voxel is.
enum class Owner : std::uint8_t { nobody, portal, hepatic };

/// Which of two vessel trees each candidate belongs to that their roots reach (through 26 neighbours).
///
/// Trees that touch are one piece of bright voxels. They are parted where that is cheapest: a minimal cut of
/// the voxel graph, an edge costing min(b)^4 / length with b the brightness of its ends, so that cuts run
/// through dim and narrow places. Each voxel leans a little to the tree whose root is the nearer one along
/// the vessels, 0.01 (d_hepatic - d_portal) / (d_hepatic + d_portal): where a mouth is as narrow as the
/// bridges beyond it, the way decides. And a tree tapers: where the best way from one root widens again after
/// its narrowest place by more than the best way from the other does (beyond 1.5 mm, up to 2 mm more, which
/// voxels do not leave open), the voxel leans to the other tree by 0.1 a mm.
/// @param brightness 0 parenchyma, 1 the clicked vessels.
/// @param portal, hepatic roots, voxels of the field that are candidates; either may be empty.
Cancellable<std::vector<Owner>> split_trees(const Field& grid, const Mask& candidates,
                                            const std::vector<float>& brightness,
                                            const std::vector<std::size_t>& portal,
                                            const std::vector<std::size_t>& hepatic,
                                            const RunContext& context);

}  // namespace glisson::segmentation
