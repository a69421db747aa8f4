// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace glisson::fem {

/// An elimination order with little fill: order[k] is the vertex eliminated k-th. Nested dissection (METIS
/// through CHOLMOD) or minimum degree (AMD), whichever needs fewer operations. The same for the same graph.
/// @param neighbours of each vertex, without itself.
std::vector<int> fill_reducing_order(const std::vector<std::vector<int>>& neighbours);

/// Neighbours close to each other: breadth first from a vertex at the rim, fewer neighbours first (Cuthill
/// and McKee 1969). What a sweep through the matrix wants.
std::vector<int> breadth_first_order(const std::vector<std::vector<int>>& neighbours);

}  // namespace glisson::fem
