// SPDX-License-Identifier: GPL-3.0-or-later
#include "fronts.h"

#include <algorithm>
#include <queue>

#include "glisson/volume/voxel_neighbours.h"

namespace glisson::segmentation {
namespace {

constexpr float kLeastDepth2 = 1.0F;  // mm^2: a click may lie on the edge

struct Entry {
  float cost;
  std::size_t at;
  bool operator>(const Entry& other) const { return cost != other.cost ? cost > other.cost : at > other.at; }
};

}  // namespace

std::vector<std::uint8_t> first_to_reach(const Mask& open, const std::vector<float>& depth2,
                                         const std::vector<std::vector<Eigen::Vector3i>>& places) {
  std::vector<std::uint8_t> owner(open.voxels.size(), 0);
  std::vector<float> cost(open.voxels.size(), 1e30F);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::size_t who = 0; who < places.size(); ++who)
    for (const Eigen::Vector3i& p : places[who]) {
      const std::size_t at = open.offset(p.x(), p.y(), p.z());
      cost[at] = 0.0F;
      owner[at] = static_cast<std::uint8_t>(who + 1);
      queue.push({0.0F, at});
    }
  const auto step_mm = static_cast<float>(open.spacing_mm.minCoeff());
  while (!queue.empty()) {
    const Entry entry = queue.top();
    queue.pop();
    if (entry.cost > cost[entry.at]) continue;
    each_face_neighbour(open.size, entry.at, [&](std::size_t other, int) {
      if (open.voxels[other] == 0) return;
      const float next = entry.cost + step_mm / std::max(depth2[other], kLeastDepth2);
      if (next >= cost[other]) return;
      cost[other] = next;
      owner[other] = owner[entry.at];
      queue.push({next, other});
    });
  }
  return owner;
}

}  // namespace glisson::segmentation
