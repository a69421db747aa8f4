// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field.h"
#include "glisson/core/run_context.h"

namespace glisson::segmentation {

/// Reward of a voxel that is known to belong to the region; negative: known not to.
inline constexpr float kKnown = 1e4F;

/// The region R of the open voxels that maximises the sum of its rewards less the cost of its surface,
/// exactly (Boykov and Jolly 2001; see MinCut):
///   sum over R of h reward - sum over faces between R and the rest of t + (1 - t) / (1 + (dI / c)^2)
/// h the voxels' edge in mm, dI the difference across the face, c = 20 HU, t = 0.1. Surface is cheap where
/// the picture has an edge but nowhere free, so that a body goes with the neighbour that it shares most of
/// its border with.
/// @param reward per mm. @param open voxels that may belong to it; the rest does not.
/// Empty: cancelled.
Cancellable<Mask> best_region(const Field& ct, const Mask& open, const std::vector<float>& reward,
                              const RunContext& context);

}  // namespace glisson::segmentation
