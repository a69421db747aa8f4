// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "glisson/core/run_context.h"

namespace glisson::segmentation {

/// The cheapest parting in two of the nodes of an undirected voxel graph, each node with up to 26 neighbours:
/// the sum of the capacities between the sides, and of the leanings of the nodes that end on the other side
/// than they lean to (Greig, Porteous and Seheult 1989), by Dinic's flow (1970): breadth-first levels,
/// blocking flows along them.
class MinCut {
 public:
  static constexpr int kDirections = 26;
  static constexpr int kNone = -1;

  explicit MinCut(std::size_t nodes);
  /// Joins two nodes. @param direction of `to` seen from `from`, 0..25; it is 25 - direction the other way.
  /// @pre capacity >= 0
  void join(std::size_t from, std::size_t to, int direction, float capacity);
  /// What it costs to put a node on the second side (positive) or on the first (negative: so much).
  void lean(std::size_t node, float cost);
  static constexpr float kBound = 1e9F;  ///< leaning of a node whose side is known

  /// 1 for nodes on the first side, else 0; as few on the first as the least cost allows. Empty when
  /// cancelled.
  Cancellable<std::vector<std::uint8_t>> first_side(const RunContext& context);

 private:
  bool find_levels();
  float push_from(std::size_t source);

  std::vector<std::array<int, kDirections>> neighbour_;
  std::vector<std::array<float, kDirections>> residual_;
  std::vector<float> from_source_, to_sink_;
  std::vector<int> level_;
  std::vector<std::uint8_t> next_arc_;
};

}  // namespace glisson::segmentation
