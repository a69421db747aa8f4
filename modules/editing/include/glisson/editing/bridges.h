// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "glisson/core/frames.h"
#include "glisson/patient/label_map.h"

/// @file
/// Where the portal and the hepatic tree run into each other: to be looked at, and cut. Pure functions, safe
/// to call from several threads.

namespace glisson::editing {

/// A place where the two trees touch.
struct Bridge {
  Point<CtFrame> p_in_ct;    ///< the voxel of the contact nearest to its middle
  double contact_mm2 = 0.0;  ///< area of the voxel faces between the trees
  long voxels = 0;           ///< of either tree that touch the other
};
/// All contacts of portal and hepatic voxels through faces, one for each connected patch, the largest first.
std::vector<Bridge> find_bridges(const LabelMap& labels);

/// A place where a part of one tree hangs on it by a neck, as a part does that belongs to the other tree.
struct Joint {
  Label tree = structure::kPortalVein;
  Point<CtFrame> p_in_ct;   ///< middle of the neck: where reassign_branch() cuts
  double neck_mm2 = 0.0;    ///< cross-section there
  double widest_mm2 = 0.0;  ///< largest cross-section beyond
  double beyond_ml = 0.0;   ///< volume beyond
};
/// Vessels become thinner from the root to the tips. A neck beyond which a tree is wide again, for at least
/// `least_ml`, is therefore suspicious: twice the neck's cross-section, taken over 5 mm of the way. Only a
/// hint: a stenosis and a badly enhanced mouth look alike. The root is each piece's thickest place. By volume
/// beyond, the largest first.
std::vector<Joint> find_joined(const LabelMap& labels, double least_ml = 0.3);

/// Everything of `from` beyond the thinnest cross-section near a click, seen from the root of the tree there,
/// becomes `to`. Cross-sections are those within 6 mm of way on either side of the click, up to the next
/// fork, and as thick as 1.5 voxels. A click at a fork (up to 3 mm or 1.5 radii before the branches part)
/// means the branch behind it that is nearest to the click, not the trunk; unless there is a neck before it.
/// Where a tree's branches meet again (a second bridge), the part that is nearer to the root by the other way
/// stays. Bricks that do not change are shared.
/// @param p within 5 mm of a voxel of `from`.
/// @param root of the tree; none: its thickest place.
/// @throws InputError naming "click": no such voxel near, or the click lies at the root itself.
LabelVolume reassign_branch(const LabelVolume& labels, Label from, Label to, const Point<CtFrame>& p,
                            const std::optional<Point<CtFrame>>& root = {});

}  // namespace glisson::editing
