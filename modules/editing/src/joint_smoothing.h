// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "glisson/core/run_context.h"
#include "label_votes.h"

namespace glisson::editing {

/// Whether a voxel of the block may go from one label to another.
using MayChange = std::function<bool(int i, int j, int k, Label from, Label to)>;

/// All labels of a block evened at once. A voxel goes to the label l of the largest share f_l + b_l of a ball
/// about it, and the b_l are those with which each label keeps its volume (the dual of an assignment with
/// given sizes): a plain majority takes from whatever is convex, and from vessels first. Where a structure is
/// thinner than the ball, its ball is halved until it fits in; what not even a ball of a voxel fits into
/// stays. So the shares at a vessel's wall are alike, however thin it is, and its branches stay. The
/// parenchyma and the background have no such thin parts: what runs between vessels is theirs.
/// @return the labels of the block; empty: cancelled.
Cancellable<std::vector<Label>> smoothed_jointly(const Block& block, const Eigen::Vector3d& spacing_mm,
                                                 double radius_mm, const MayChange& may_change,
                                                 const RunContext& context);

}  // namespace glisson::editing
