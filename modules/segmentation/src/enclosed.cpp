// SPDX-License-Identifier: GPL-3.0-or-later
#include "enclosed.h"

#include "bites.h"
#include "region_cut.h"

namespace glisson::segmentation {
namespace {

constexpr double kDeep = 4.0;     // mm below the border of the liver found so far
constexpr float kEmpty = -30.0F;  // HU: fat, lung and gas are no part of it
constexpr float kFluid = 25.0F;   // HU below which a body at the rim may be a gallbladder or ascites
/// Per mm: what was found, what looks unlike the liver, and what is fluid.
constexpr float kFound = 0.1F, kUnlike = -0.01F, kUnlikeFluid = -0.1F;

}  // namespace

Cancellable<Mask> with_enclosed(const Field& ct, const Mask& found, const Mask& like, const Mask& own,
                                const Mask& barred, const Mask& included, const Mask& likely,
                                const LiverSeeds& seeds, const RunContext& context) {
  Mask open = with_bites(found);
  if (context.cancelled()) return std::nullopt;
  const Mask deep = eroded(found, kDeep);
  std::vector<float> reward(open.voxels.size(), 0.0F);
  for (std::size_t i = 0; i < reward.size(); ++i) {
    if (found.voxels[i] != 0 || likely.voxels[i] != 0)
      reward[i] = kFound;
    else if (like.voxels[i] == 0)
      reward[i] = ct.values[i] < kFluid ? kUnlikeFluid : kUnlike;
    if (deep.voxels[i] != 0 || included.voxels[i] != 0) reward[i] = kKnown;
    const bool parted = like.voxels[i] != 0 && own.voxels[i] == 0 && reward[i] == 0.0F;
    if (barred.voxels[i] != 0 || parted) reward[i] = -kKnown;
    open.voxels[i] = (open.voxels[i] != 0 && ct.values[i] > kEmpty) || reward[i] == kKnown;
  }
  for (const Eigen::Vector3i& p : seeds.inside) {
    open.voxels[ct.offset(p)] = 1;
    reward[ct.offset(p)] = kKnown;
  }
  for (const Eigen::Vector3i& p : seeds.outside) reward[ct.offset(p)] = -kKnown;
  const auto region = best_region(ct, open, reward, context);
  if (!region) return std::nullopt;
  return holes_filled(largest_component(*region));
}

}  // namespace glisson::segmentation
