// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "block_matrix.h"

namespace glisson::fem {

/// Columns that are eliminated together, and the rows below that they touch. Numbers of 3 x 3 blocks.
struct Front {
  int first = 0, columns = 0;
  std::vector<int> rows;      ///< below the columns, ascending
  std::vector<int> children;  ///< fronts, ascending
  int parent = -1;
  /// Where each row is in the parent: below parent.columns its column, from there on its row.
  std::vector<int> place_in_parent;
};

/// The elimination tree of a pattern in postorder, its columns gathered into fronts. Joining a front to its
/// parent stores zeros and saves a front: it is done where it saves time.
std::vector<Front> build_fronts(const BlockPattern& pattern);

/// About how many multiplications a front takes.
double front_work(const Front& front);

/// Fronts in groups, each ascending. All but the last may be worked on at once: whole subtrees, none of which
/// needs another; the last holds what is above them, and comes after.
using FrontGroups = std::vector<std::vector<int>>;
/// Three groups, for two threads, as equal as whole subtrees allow. The tree alone decides.
FrontGroups share_out(const std::vector<Front>& fronts);
/// One group.
FrontGroups in_one_go(const std::vector<Front>& fronts);

/// Where to put each front's buffer in one piece of memory. A buffer is needed from its own turn to its
/// parent's (inclusive); places that are free again are used again. Each group has a space of its own.
/// @param total receives the space needed.
std::vector<std::size_t> plan_memory(const std::vector<Front>& fronts, const FrontGroups& groups,
                                     const std::vector<std::size_t>& sizes, std::size_t* total);

}  // namespace glisson::fem
