// SPDX-License-Identifier: GPL-3.0-or-later
#include "min_cut.h"

#include <algorithm>

#include "glisson/core/error.h"

namespace glisson::segmentation {
namespace {

/// Residuals below this are full: rounding must not keep the flow alive.
constexpr float kFull = 1e-6F;
constexpr std::size_t kPollEvery = 4096;  // nodes between two looks at whether to stop

}  // namespace

MinCut::MinCut(std::size_t nodes)
    : neighbour_(nodes),
      residual_(nodes),
      from_source_(nodes, 0.0F),
      to_sink_(nodes, 0.0F),
      level_(nodes),
      next_arc_(nodes) {
  for (auto& arcs : neighbour_) arcs.fill(kNone);
  for (auto& arcs : residual_) arcs.fill(0.0F);
}

void MinCut::join(std::size_t from, std::size_t to, int direction, float capacity) {
  require(capacity >= 0.0F && direction >= 0 && direction < kDirections,
          "a join has a capacity and a direction");
  const auto there = static_cast<std::size_t>(direction), back = static_cast<std::size_t>(25 - direction);
  neighbour_[from][there] = static_cast<int>(to);
  neighbour_[to][back] = static_cast<int>(from);
  residual_[from][there] = residual_[to][back] = capacity;
}

void MinCut::lean(std::size_t node, float cost) {
  from_source_[node] = std::max(0.0F, cost);
  to_sink_[node] = std::max(0.0F, -cost);
}

bool MinCut::find_levels() {
  std::fill(level_.begin(), level_.end(), -1);
  std::vector<std::size_t> queue;
  for (std::size_t n = 0; n < level_.size(); ++n)
    if (from_source_[n] > kFull) {
      level_[n] = 0;
      queue.push_back(n);
    }
  int sink_level = -1;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::size_t at = queue[head];
    if (sink_level >= 0 && level_[at] >= sink_level) break;
    for (std::size_t d = 0; d < kDirections; ++d) {
      const int other = neighbour_[at][d];
      if (other == kNone || residual_[at][d] <= kFull) continue;
      const auto to = static_cast<std::size_t>(other);
      if (level_[to] >= 0) continue;
      level_[to] = level_[at] + 1;
      if (sink_level < 0 && to_sink_[to] > kFull) sink_level = level_[to];
      queue.push_back(to);
    }
  }
  return sink_level >= 0;
}

/// One path along falling room; what it carried. 0 when no path is left.
float MinCut::push_from(std::size_t source) {
  std::vector<std::pair<std::size_t, std::size_t>> path;  // node and arc taken
  std::size_t at = source;
  while (true) {
    if (to_sink_[at] > kFull) {
      float room = std::min(from_source_[source], to_sink_[at]);
      for (const auto& [node, arc] : path) room = std::min(room, residual_[node][arc]);
      for (const auto& [node, arc] : path) {
        residual_[node][arc] -= room;
        residual_[static_cast<std::size_t>(neighbour_[node][arc])][25 - arc] += room;
      }
      from_source_[source] -= room;
      to_sink_[at] -= room;
      return room;
    }
    std::uint8_t& arc = next_arc_[at];
    for (; arc < kDirections; ++arc) {
      const int other = neighbour_[at][arc];
      if (other != kNone && residual_[at][arc] > kFull &&
          level_[static_cast<std::size_t>(other)] == level_[at] + 1)
        break;
    }
    if (arc < kDirections) {
      path.emplace_back(at, arc);
      at = static_cast<std::size_t>(neighbour_[at][arc]);
      continue;
    }
    if (path.empty()) return 0.0F;
    level_[at] = -1;  // a dead end
    at = path.back().first;
    ++next_arc_[at];
    path.pop_back();
  }
}

Cancellable<std::vector<std::uint8_t>> MinCut::first_side(const RunContext& context) {
  while (find_levels()) {
    if (context.cancelled()) return std::nullopt;
    std::fill(next_arc_.begin(), next_arc_.end(), std::uint8_t{0});
    for (std::size_t n = 0; n < level_.size(); ++n) {
      if (n % kPollEvery == 0 && context.cancelled()) return std::nullopt;
      while (from_source_[n] > kFull && push_from(n) > 0.0F) {
      }
    }
  }
  std::vector<std::uint8_t> side(level_.size());
  for (std::size_t n = 0; n < side.size(); ++n) side[n] = level_[n] >= 0 ? 1 : 0;
  return side;
}

}  // namespace glisson::segmentation
