// SPDX-License-Identifier: GPL-3.0-or-later
#include "enclosed.h"

#include <algorithm>
#include <cmath>

#include "bites.h"
#include "region_cut.h"
#include "sight.h"

namespace glisson::segmentation {
namespace {

constexpr double kDeep = 4.0;    // mm below the border of the liver found so far
constexpr float kFluid = 25.0F;  // HU below which a body at the rim may be a gallbladder or ascites
/// Of what is seen from a place, from which on it is rather enclosed than beside the liver. A gallbladder in
/// its bed, or fluid around the liver, is seen from a half at most; most of a cyst at the rim is deeper.
constexpr double kEnclosed = 0.5, kEnclosedFluid = 0.65;
/// Per mm: what was found; what looks unlike the liver, by how much of it is enclosed; what is brighter, as
/// vessels and kidneys are; and what is fluid.
constexpr float kFound = 0.1F, kEnclosing = 0.1F, kLeastUnlike = -0.01F, kMostUnlike = 0.03F,
                kBright = -0.01F, kUnlikeFluid = -0.1F;

}  // namespace

Cancellable<Mask> with_enclosed(const Field& ct, const Mask& found, const Tissue& liver, const Mask& like,
                                const Mask& own, const Mask& barred, const Mask& included, const Mask& likely,
                                const LiverSeeds& seeds, const RunContext& context) {
  Mask open = with_bites(found);
  if (context.cancelled()) return std::nullopt;
  const Mask deep = eroded(found, kDeep);
  // What was found of the liver says better how dark it is than a few clicks did, one of them in a cyst.
  Mask alike = like;
  const auto darkest = static_cast<float>(liver.mean - kLiverWidth * std::max(liver.sigma, kDrift));
  for (std::size_t i = 0; i < alike.voxels.size(); ++i)
    if (ct.values[i] < darkest) alike.voxels[i] = 0;
  const Sight sight(ct, found);
  const auto unlike = [&](std::size_t at) {
    const bool is_fluid = ct.values[at] < kFluid;
    const float least = is_fluid ? kUnlikeFluid : kLeastUnlike,
                most = ct.values[at] > static_cast<float>(liver.mean) ? kBright : kMostUnlike;
    const double beyond = sight.share_of_liver(at) - (is_fluid ? kEnclosedFluid : kEnclosed);
    return std::clamp(kEnclosing * static_cast<float>(beyond), least, most);
  };
  std::vector<float> reward(open.voxels.size(), 0.0F);
  for (std::size_t i = 0; i < reward.size(); ++i) {
    if (found.voxels[i] != 0 || likely.voxels[i] != 0)
      reward[i] = kFound;
    else if (alike.voxels[i] == 0 && open.voxels[i] != 0)
      reward[i] = unlike(i);
    if (deep.voxels[i] != 0 || included.voxels[i] != 0) reward[i] = kKnown;
    // Darker than that it stays parted where it is not enclosed.
    const bool parted = like.voxels[i] != 0 && own.voxels[i] == 0 && !(reward[i] > 0.0F);
    if (barred.voxels[i] != 0 || parted) reward[i] = -kKnown;
    open.voxels[i] = (open.voxels[i] != 0 && ct.values[i] > kEmptyTissue) || reward[i] == kKnown;
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
