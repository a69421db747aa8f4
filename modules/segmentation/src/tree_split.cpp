// SPDX-License-Identifier: GPL-3.0-or-later
#include "tree_split.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "min_cut.h"

namespace glisson::segmentation {
namespace {

constexpr float kLeaning = 0.01F;  // per voxel; 0.003 to 0.05 part the trees of the real patient alike
constexpr float kDimmest = 0.02F, kBrightest = 1.2F;
constexpr float kDimIsLong = 3.0F;   // a mm in the dark is as long as 1 + so many in the light
constexpr double kRootRadius = 3.0;  // mm around a root that are its tree's
constexpr float kFar = 1e30F;

struct Entry {
  float cost;
  std::size_t at;
  bool operator>(const Entry& other) const { return cost != other.cost ? cost > other.cost : at > other.at; }
};

/// The 26 neighbours in memory order; `direction` and 25 - direction are opposite.
struct Step {
  Eigen::Vector3i by;
  float length;  ///< mm
};
std::array<Step, 26> steps_of(const Field& grid) {
  std::array<Step, 26> steps;
  std::size_t n = 0;
  for (int k = -1; k <= 1; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i)
        if (i != 0 || j != 0 || k != 0)
          steps[n++] = {{i, j, k},
                        static_cast<float>(Eigen::Vector3d(i, j, k).cwiseProduct(grid.spacing_mm).norm())};
  return steps;
}

Eigen::Vector3i place_of(const Field& grid, std::size_t at) {
  const auto nx = static_cast<std::size_t>(grid.size.x()),
             slice = nx * static_cast<std::size_t>(grid.size.y());
  return {static_cast<int>(at % nx), static_cast<int>((at % slice) / nx), static_cast<int>(at / slice)};
}

/// Length of the shortest way from the roots through the candidates; dim stretches count for more.
std::vector<float> way_from(const Field& grid, const Mask& candidates, const std::vector<float>& brightness,
                            const std::vector<std::size_t>& roots) {
  const std::array<Step, 26> steps = steps_of(grid);
  std::vector<float> way(candidates.voxels.size(), kFar);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::size_t root : roots) {
    way[root] = 0.0F;
    queue.push({0.0F, root});
  }
  while (!queue.empty()) {
    const Entry entry = queue.top();
    queue.pop();
    if (entry.cost > way[entry.at]) continue;
    const Eigen::Vector3i v = place_of(grid, entry.at);
    for (const Step& step : steps) {
      const Eigen::Vector3i w = v + step.by;
      if (!grid.contains(w)) continue;
      const std::size_t other = grid.offset(w);
      if (candidates.voxels[other] == 0) continue;
      const float dark = 1.0F - std::clamp(brightness[other], 0.0F, 1.0F);
      const float next = entry.cost + step.length * (1.0F + kDimIsLong * dark * dark);
      if (next >= way[other]) continue;
      way[other] = next;
      queue.push({next, other});
    }
  }
  return way;
}

/// The candidates that both roots reach, numbered.
struct Shared {
  std::vector<int> number;
  std::vector<std::size_t> at;
};

void bind_roots(const Field& grid, const Shared& shared, const std::vector<std::size_t>& roots, float side,
                MinCut& cut) {
  const int reach = static_cast<int>(std::ceil(kRootRadius / grid.spacing_mm.minCoeff()));
  for (const std::size_t root : roots) {
    const Eigen::Vector3i v = place_of(grid, root);
    for (int k = -reach; k <= reach; ++k)
      for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) {
          const Eigen::Vector3i w = v + Eigen::Vector3i(i, j, k);
          if (Eigen::Vector3d(i, j, k).cwiseProduct(grid.spacing_mm).norm() > kRootRadius ||
              !grid.contains(w))
            continue;
          const int node = shared.number[grid.offset(w)];
          if (node >= 0) cut.lean(static_cast<std::size_t>(node), side * MinCut::kBound);
        }
  }
}

void join_neighbours(const Field& grid, const Shared& shared, const std::vector<float>& brightness,
                     MinCut& cut) {
  const std::array<Step, 26> steps = steps_of(grid);
  for (std::size_t node = 0; node < shared.at.size(); ++node) {
    const Eigen::Vector3i v = place_of(grid, shared.at[node]);
    for (std::size_t d = 13; d < 26; ++d) {
      const Eigen::Vector3i w = v + steps[d].by;
      if (!grid.contains(w)) continue;
      const std::size_t other = grid.offset(w);
      if (shared.number[other] < 0) continue;
      const float b =
          std::clamp(std::min(brightness[shared.at[node]], brightness[other]), kDimmest, kBrightest);
      cut.join(node, static_cast<std::size_t>(shared.number[other]), static_cast<int>(d),
               b * b * b * b / steps[d].length);
    }
  }
}

}  // namespace

Cancellable<std::vector<Owner>> split_trees(const Field& grid, const Mask& candidates,
                                            const std::vector<float>& brightness,
                                            const std::vector<std::size_t>& portal,
                                            const std::vector<std::size_t>& hepatic,
                                            const RunContext& context) {
  const std::vector<float> to_portal = way_from(grid, candidates, brightness, portal),
                           to_hepatic = way_from(grid, candidates, brightness, hepatic);
  std::vector<Owner> owner(candidates.voxels.size(), Owner::nobody);
  Shared shared;
  shared.number.assign(owner.size(), -1);
  for (std::size_t i = 0; i < owner.size(); ++i) {
    const bool a = to_portal[i] < kFar, b = to_hepatic[i] < kFar;
    if (a && b) {
      shared.number[i] = static_cast<int>(shared.at.size());
      shared.at.push_back(i);
    } else if (a || b) {
      owner[i] = a ? Owner::portal : Owner::hepatic;
    }
  }
  MinCut cut(shared.at.size());
  join_neighbours(grid, shared, brightness, cut);
  for (std::size_t node = 0; node < shared.at.size(); ++node) {
    const float p = to_portal[shared.at[node]], h = to_hepatic[shared.at[node]];
    cut.lean(node, kLeaning * (h - p) / (h + p + 1.0F));
  }
  bind_roots(grid, shared, hepatic, -1.0F, cut);
  bind_roots(grid, shared, portal, 1.0F, cut);
  const auto side = cut.first_side(context);
  if (!side) return std::nullopt;
  for (std::size_t node = 0; node < shared.at.size(); ++node)
    owner[shared.at[node]] = (*side)[node] != 0 ? Owner::portal : Owner::hepatic;
  return owner;
}

}  // namespace glisson::segmentation
