// SPDX-License-Identifier: GPL-3.0-or-later
#include "tree_split.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "glisson/volume/morphology.h"
#include "min_cut.h"

namespace glisson::segmentation {
namespace {

constexpr float kLeaning = 0.01F;  // per voxel; 0.003 to 0.05 part the trees of the real patient alike
/// Towards the tree that need not widen, per voxel and mm: a tree tapers from its root.
constexpr float kTaper = 0.1F;
constexpr float kUnsure = 1.5F;            // mm of widening that voxels of 1 mm do not tell
constexpr float kMostWidening = 2.0F;      // mm beyond that, which count
constexpr float kWideningIsLong = 100.0F;  // mm of way that a mm of widening is worth
constexpr float kRagged = 10.0F;  // mm from a root, where it may widen: a click's place, a cava's wall
constexpr float kSurface = 1.5F;  // mm around an opening that belong to it
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

/// The least costs from the roots through the candidates (Dijkstra). `next(from, to, length, cost)` is the
/// cost at `to`, `take(from, to, cost)` is told when that is the least so far.
template <class Next, class Take>
std::vector<float> least_costs(const Field& grid, const Mask& candidates,
                               const std::vector<std::size_t>& roots, const Next& next, const Take& take) {
  const std::array<Step, 26> steps = steps_of(grid);
  std::vector<float> costs(candidates.voxels.size(), kFar);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::size_t root : roots) {
    costs[root] = 0.0F;
    queue.push({0.0F, root});
  }
  while (!queue.empty()) {
    const Entry entry = queue.top();
    queue.pop();
    if (entry.cost > costs[entry.at]) continue;
    const Eigen::Vector3i v = place_of(grid, entry.at);
    for (const Step& step : steps) {
      const Eigen::Vector3i w = v + step.by;
      if (!grid.contains(w)) continue;
      const std::size_t other = grid.offset(w);
      if (candidates.voxels[other] == 0) continue;
      const float cost = next(entry.at, other, step.length, entry.cost);
      if (cost >= costs[other]) continue;
      costs[other] = cost;
      take(entry.at, other, entry.cost);
      queue.push({cost, other});
    }
  }
  return costs;
}

/// Length of the shortest way from the roots through the candidates; dim stretches count for more.
std::vector<float> way_from(const Field& grid, const Mask& candidates, const std::vector<float>& brightness,
                            const std::vector<std::size_t>& roots) {
  return least_costs(
      grid, candidates, roots,
      [&](std::size_t, std::size_t to, float length, float cost) {
        const float dark = 1.0F - std::clamp(brightness[to], 0.0F, 1.0F);
        return cost + length * (1.0F + kDimIsLong * dark * dark);
      },
      [](std::size_t, std::size_t, float) {});
}

/// Of the vessel around each voxel, mm: of the largest ball in it that reaches there or nearly so, for on a
/// vessel's surface only small ones do.
std::vector<float> radius_of(const Mask& candidates) {
  constexpr std::array<double, 10> kRadii = {1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 7.0};
  std::vector<float> radius(candidates.voxels.size(), 0.5F);
  for (const double r : kRadii) {
    const Mask around = dilated(eroded(candidates, r), r + kSurface);
    if (around.count() == 0) break;
    for (std::size_t i = 0; i < radius.size(); ++i)
      if (around.voxels[i] != 0) radius[i] = static_cast<float>(r);
  }
  return radius;
}

/// By how much a way from the roots gets wider again than it has been, mm, at each voxel: of the ways with
/// the least of it. 0 where none leads.
std::vector<float> widening_from(const Field& grid, const Mask& candidates, const std::vector<float>& radius,
                                 const std::vector<std::size_t>& roots) {
  std::vector<float> narrowest(radius.size(), kFar), widening(radius.size(), 0.0F);
  const auto widened = [&](std::size_t from, std::size_t to) {
    return std::max(widening[from], radius[to] - narrowest[from]);
  };
  least_costs(
      grid, candidates, roots,
      [&](std::size_t from, std::size_t to, float length, float cost) {
        return cost + length + kWideningIsLong * (widened(from, to) - widening[from]);
      },
      [&](std::size_t from, std::size_t to, float cost) {
        widening[to] = widened(from, to);
        narrowest[to] = cost < kRagged ? kFar : std::min(narrowest[from], radius[to]);
      });
  return widening;
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
  if (context.cancelled()) return std::nullopt;
  const std::vector<float> radius = radius_of(candidates),
                           from_portal = widening_from(grid, candidates, radius, portal),
                           from_hepatic = widening_from(grid, candidates, radius, hepatic);
  MinCut cut(shared.at.size());
  join_neighbours(grid, shared, brightness, cut);
  for (std::size_t node = 0; node < shared.at.size(); ++node) {
    const std::size_t at = shared.at[node];
    const float p = to_portal[at], h = to_hepatic[at], wider = from_hepatic[at] - from_portal[at];
    const float sure = std::clamp(std::abs(wider) - kUnsure, 0.0F, kMostWidening);
    cut.lean(node, kLeaning * (h - p) / (h + p + 1.0F) + kTaper * std::copysign(sure, wider));
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
