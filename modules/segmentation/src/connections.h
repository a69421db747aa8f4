// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/patient/label_map.h"

namespace glisson::segmentation {

/// Ways from a tree's root to its tips, counted in one segmentation and looked for in another.
struct Connections {
  int ways = 0;   ///< of the first
  int found = 0;  ///< of them, those that the second has
};

/// Which ends of a tree count, and when a way to one counts as found.
struct ConnectionOptions {
  double least_branch_mm = 10.0;  ///< a tip ends a branch at least so long
  double reach_mm = 3.0;          ///< from the middle of a cross-section to a voxel of the second
  double least_share = 0.9;       ///< of a way's cross-sections that must be reached, the tip's among them
  /// @throws InputError naming the field that is out of range.
  void validate() const;
};

/// A way is the chain of cross-sections (see find_joined()) from the tree's thickest place to a tip, as far
/// as it lies in the liver and in the tree's own label; hepatic veins are followed through the cava, so that
/// all of them have one root. It is found when one connected piece (26 neighbours) of the second's same label
/// lies along it: gaps and borrowed branches do not count. With the truth first this is how many of its ways
/// were found; with the truth second, how many that were found are true.
/// @param tree portal vein or hepatic veins. @param liver dense 0/1: where tips are counted
///   (the cut end of a trunk lies outside).
/// @pre one grid. @throws InputError as validate().
Connections count_connections(const LabelMap& of, const LabelMap& in, Label tree,
                              const std::vector<std::uint8_t>& liver, const ConnectionOptions& options = {});

}  // namespace glisson::segmentation
