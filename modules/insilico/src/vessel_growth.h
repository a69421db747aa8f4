// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/core/run_context.h"
#include "liver_shape.h"

namespace glisson::insilico {

/// A vessel tree in LPS millimetres. Node 0 is the root; every parent comes before its children.
struct GrownTree {
  std::vector<Vec> nodes;
  std::vector<int> parents;   ///< -1 at the root
  std::vector<double> radii;  ///< by Murray's law from the terminals
  std::vector<char> outside;  ///< whether the node may lie outside the liver (trunk, stump in the cava)

  int size() const { return static_cast<int>(nodes.size()); }
  int terminal_count() const;
};

struct GrowthOptions {
  double portal_root_radius = 6.0;
  double hepatic_root_radius = 6.5;  ///< of the stump in the cava, that all hepatic veins share
  int terminals = 190;               ///< aimed at, per tree
  double clearance = 2.5;            ///< least distance between the walls of the two trees
};

struct GrownTrees {
  GrownTree portal, hepatic;
};

/// Grows both trees by constrained constructive optimisation in the spirit of Schreiner and Buxbaum 1993:
/// main branches are laid by anatomy, then terminals come one by one, wide apart first, and join where the
/// added length plus a share of the way from the root is least, unless the branch would leave the liver, come
/// near the other tree, its own tree or a lesion. Radii follow Murray's law (r^3 = sum of r_i^3); last, what
/// is still too near is pruned. Empty when cancelled.
Cancellable<GrownTrees> grow_trees(const LiverShape& shape, const std::vector<Lesion>& lesions,
                                   const GrowthOptions& options, const RunContext& context);

/// Lays the main branches only (to place lesions clear of them).
GrownTrees main_branches(const LiverShape& shape, const GrowthOptions& options);

/// Sets the radii by Murray's law: the root has `root_radius`, all terminals are alike.
void apply_murray(GrownTree& tree, double root_radius);

/// Distance between the segments p1 q1 and p2 q2.
double segment_distance(const Vec& p1, const Vec& q1, const Vec& p2, const Vec& q2);

/// Least distance between the walls of the two trees, millimetres (negative: they overlap).
double wall_clearance(const GrownTree& a, const GrownTree& b);

}  // namespace glisson::insilico
