// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/label_difference.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/volume/brick_voxels.h"

namespace glisson {
namespace {

constexpr int kSide = LabelVolume::kSide;
constexpr std::size_t kBrickVoxels = static_cast<std::size_t>(kSide) * kSide * kSide;

Label label_in(const std::shared_ptr<const LabelVolume::Brick>& brick, std::size_t i) {
  return brick ? (*brick)[i] : Label{0};
}

void require_one_grid(const LabelVolume& mine, const LabelVolume& offered, const LabelVolume& hand) {
  require(mine.grid().same_as(offered.grid()) && mine.grid().same_as(hand.grid()),
          "labels are compared on one grid");
}

/// The voxel in the fullest layer that is closest to the middle of those there.
std::optional<Eigen::Vector3i> place_of_most(const std::vector<Eigen::Vector3i>& voxels) {
  if (voxels.empty()) return {};
  std::map<int, long> layers;
  for (const Eigen::Vector3i& v : voxels) ++layers[v.z()];
  const int layer = std::max_element(layers.begin(), layers.end(), [](const auto& a, const auto& b) {
                      return a.second < b.second;
                    })->first;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3i& v : voxels)
    if (v.z() == layer) middle += v.cast<double>() / static_cast<double>(layers[layer]);
  std::optional<Eigen::Vector3i> best;
  double closest = std::numeric_limits<double>::max();
  for (const Eigen::Vector3i& v : voxels) {
    const double distance = (v.cast<double>() - middle).squaredNorm();
    if (v.z() != layer || distance >= closest) continue;
    closest = distance;
    best = v;
  }
  return best;
}

}  // namespace

LabelDifference label_difference(const LabelVolume& mine, const LabelVolume& offered,
                                 const LabelVolume& hand) {
  require_one_grid(mine, offered, hand);
  LabelDifference difference;
  std::vector<Eigen::Vector3i> all, of_hand;
  for (const LabelChange& change : offered.changes_since(mine)) {
    const auto& marked = hand.brick(change.number);
    for (std::size_t i = 0; i < kBrickVoxels; ++i) {
      const Label was = label_in(change.before, i), will = label_in(change.after, i);
      if (was == will) continue;
      ++difference.labels[was].lost;
      ++difference.labels[will].gained;
      all.push_back(voxel_of(mine, change.number, i));
      if (label_in(marked, i) != 0) of_hand.push_back(all.back());
    }
  }
  difference.labels.erase(Label{0});
  difference.voxels_changed = static_cast<long>(all.size());
  difference.hand_changed = static_cast<long>(of_hand.size());
  for (std::size_t n = 0; n < hand.brick_count(); ++n)
    if (const auto& brick = hand.brick(n))
      difference.hand_voxels += std::count_if(brick->begin(), brick->end(), [](Label v) { return v != 0; });
  difference.where_most = place_of_most(of_hand.empty() ? all : of_hand);
  return difference;
}

LabelVolume keeping_hand(const LabelVolume& mine, const LabelVolume& offered, const LabelVolume& hand) {
  require_one_grid(mine, offered, hand);
  LabelVolume kept = offered;
  for (const LabelChange& change : offered.changes_since(mine)) {
    const auto& marked = hand.brick(change.number);
    if (!marked) continue;
    auto brick = std::make_shared<LabelVolume::Brick>();
    for (std::size_t i = 0; i < kBrickVoxels; ++i)
      (*brick)[i] = label_in((*marked)[i] != 0 ? change.before : change.after, i);
    kept.set_brick(change.number, std::move(brick));
  }
  return kept;
}

}  // namespace glisson
