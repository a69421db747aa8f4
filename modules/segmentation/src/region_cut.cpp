// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_cut.h"

#include <algorithm>
#include <array>

#include "min_cut.h"

namespace glisson::segmentation {
namespace {

constexpr float kEdge = 20.0F;    // HU at which a surface costs half
constexpr float kTension = 0.1F;  // of a surface on the strongest edge
constexpr int kNobody = -1;

float surface_cost(const Field& ct, std::size_t a, std::size_t b) {
  const float d = (ct.values[a] - ct.values[b]) / kEdge;
  return kTension + (1.0F - kTension) / (1.0F + d * d);
}

/// Calls visit(voxel, next voxel, direction as MinCut has it) for each face between two voxels.
template <class Visit>
void each_face(const Field& ct, const Visit& visit) {
  const auto sy = static_cast<std::size_t>(ct.size.x());
  const std::size_t sz = sy * static_cast<std::size_t>(ct.size.y());
  std::size_t at = 0;
  for (int k = 0; k < ct.size.z(); ++k)
    for (int j = 0; j < ct.size.y(); ++j)
      for (int i = 0; i < ct.size.x(); ++i, ++at) {
        if (i + 1 < ct.size.x()) visit(at, at + 1, 13);
        if (j + 1 < ct.size.y()) visit(at, at + sy, 15);
        if (k + 1 < ct.size.z()) visit(at, at + sz, 21);
      }
}

}  // namespace

Cancellable<Mask> best_region(const Field& ct, const Mask& open, const std::vector<float>& reward,
                              const RunContext& context) {
  std::vector<int> node(open.voxels.size(), kNobody);
  std::vector<float> leaning;
  const auto edge_mm = static_cast<float>(ct.spacing_mm.minCoeff());
  for (std::size_t i = 0; i < node.size(); ++i) {
    if (open.voxels[i] == 0) continue;
    node[i] = static_cast<int>(leaning.size());
    leaning.push_back(edge_mm * reward[i]);
  }
  MinCut cut(leaning.size());
  const auto number = [&](std::size_t voxel) { return static_cast<std::size_t>(node[voxel]); };
  each_face(ct, [&](std::size_t a, std::size_t b, int direction) {
    if (node[a] == kNobody && node[b] == kNobody) return;
    const float cost = surface_cost(ct, a, b);
    if (node[a] == kNobody)
      leaning[number(b)] -= cost;
    else if (node[b] == kNobody)
      leaning[number(a)] -= cost;
    else
      cut.join(number(a), number(b), direction, cost);
  });
  for (std::size_t n = 0; n < leaning.size(); ++n) cut.lean(n, leaning[n]);
  const auto side = cut.first_side(context);
  if (!side) return std::nullopt;
  Mask region = ct.empty_mask();
  for (std::size_t i = 0; i < node.size(); ++i)
    region.voxels[i] = node[i] != kNobody && (*side)[number(i)] != 0 ? 1 : 0;
  return region;
}

}  // namespace glisson::segmentation
