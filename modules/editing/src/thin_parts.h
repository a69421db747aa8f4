// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "glisson/core/run_context.h"
#include "label_votes.h"

namespace glisson::editing {

/// Balls of falling radius, and which of them fits each place of a block.
struct FittingBalls {
  std::vector<double> radii_mm;  ///< each half of the one before; the last holds a neighbour at least
  /// Of each voxel: a number into radii_mm; their count where none fits.
  std::vector<std::uint8_t> ball;
};

/// Near parts of structures (all but background and parenchyma) that a ball does not fit into the next
/// smaller one is taken. Such a part reaches further than the radius from where the ball does fit in: what is
/// nearer is roughness, which smoothing is there for. Empty: cancelled.
Cancellable<FittingBalls> fitting_balls(const Block& block, const Eigen::Vector3d& spacing_mm,
                                        double radius_mm, const RunContext& context);

}  // namespace glisson::editing
