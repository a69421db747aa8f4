// SPDX-License-Identifier: GPL-3.0-or-later
#include "enclosed.h"

#include <algorithm>
#include <cmath>

#include "bites.h"
#include "bodies.h"
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

/// A body that a cut left out though it is enclosed: thicker than a seam, and as large as nothing else is of
/// which every place sees more liver than anything else. Where a tumour meets diaphragm or heart no edge
/// shows, and to leave it out costs less than a surface there.
constexpr double kBodyRadius = 4.0, kBodyMl = 20.0;  // mm
constexpr int kMostRounds = 3;  ///< what is taken encloses more; mostly it rests after one

double share_needed(float value) { return value < kFluid ? kEnclosedFluid : kEnclosed; }

/// What is known before the liver is parted from what lies beside it (see with_enclosed()).
struct Ground {
  const Field& ct;
  const Tissue& liver;
  const Mask &like, &alike;  ///< the latter as what was found of the liver says
  const Mask &own, &barred, &included, &likely;
  const LiverSeeds& seeds;
  float darkest;  ///< HU; the liver is brighter
};

Cancellable<Mask> parted(const Ground& ground, const Mask& found, const RunContext& context) {
  const Field& ct = ground.ct;
  Mask open = with_bites(found);
  if (context.cancelled()) return std::nullopt;
  const Mask deep = eroded(found, kDeep);
  const Sight sight(ct, found);
  const auto unlike = [&](std::size_t at) {
    const float least = ct.values[at] < kFluid ? kUnlikeFluid : kLeastUnlike,
                most = ct.values[at] > static_cast<float>(ground.liver.mean) ? kBright : kMostUnlike;
    const double beyond = sight.share_of_liver(at) - share_needed(ct.values[at]);
    return std::clamp(kEnclosing * static_cast<float>(beyond), least, most);
  };
  std::vector<float> reward(open.voxels.size(), 0.0F);
  for (std::size_t i = 0; i < reward.size(); ++i) {
    if (found.voxels[i] != 0 || ground.likely.voxels[i] != 0)
      reward[i] = kFound;
    else if (ground.alike.voxels[i] == 0 && open.voxels[i] != 0)
      reward[i] = unlike(i);
    if (deep.voxels[i] != 0 || ground.included.voxels[i] != 0) reward[i] = kKnown;
    // Darker than that it stays parted where it is not enclosed.
    const bool stays = ground.like.voxels[i] != 0 && ground.own.voxels[i] == 0 && !(reward[i] > 0.0F);
    if (ground.barred.voxels[i] != 0 || stays) reward[i] = -kKnown;
    open.voxels[i] = (open.voxels[i] != 0 && ct.values[i] > kEmptyTissue) || reward[i] == kKnown;
  }
  for (const Eigen::Vector3i& p : ground.seeds.inside) {
    open.voxels[ct.offset(p)] = 1;
    reward[ct.offset(p)] = kKnown;
  }
  for (const Eigen::Vector3i& p : ground.seeds.outside) reward[ct.offset(p)] = -kKnown;
  const auto region = best_region(ct, open, reward, context);
  if (!region) return std::nullopt;
  return holes_filled(largest_component(*region));
}

/// Bodies that were left out of the liver though it encloses them; none in which somebody has clicked "not
/// liver".
Mask left_enclosed(const Ground& ground, const Mask& liver) {
  const Field& ct = ground.ct;
  Mask dark = with_bites(liver);
  for (std::size_t i = 0; i < dark.voxels.size(); ++i)
    if (liver.voxels[i] != 0 || ground.barred.voxels[i] != 0 || ct.values[i] <= kEmptyTissue ||
        ct.values[i] >= ground.darkest)
      dark.voxels[i] = 0;
  dark = opened(dark, kBodyRadius);
  const Sight sight(ct, liver);
  std::vector<double> share(dark.voxels.size(), 0.0);
  for (std::size_t i = 0; i < share.size(); ++i) {
    if (dark.voxels[i] == 0) continue;
    share[i] = sight.share_of_liver(i);
    if (share[i] < kEnclosed) dark.voxels[i] = 0;
  }
  std::vector<long> sizes;
  const std::vector<int> body = connected_components(opened(dark, kBodyRadius), sizes);
  std::vector<double> beyond(sizes.size() + 1, 0.0);  // summed over each body
  for (std::size_t i = 0; i < body.size(); ++i)
    beyond[static_cast<std::size_t>(body[i])] += share[i] - share_needed(ct.values[i]);
  const auto least = static_cast<long>(kBodyMl / (1e-3 * ct.spacing_mm.prod()));
  std::vector<char> is_taken(sizes.size() + 1, 0);
  for (std::size_t n = 1; n < is_taken.size(); ++n)
    is_taken[n] = beyond[n] > 0.0 && sizes[n - 1] >= least ? 1 : 0;
  // What lies right around such a click is barred: the body begins beside it.
  Mask clicked = ct.empty_mask();
  for (const Eigen::Vector3i& p : ground.seeds.outside) clicked.voxels[ct.offset(p)] = 1;
  const Mask refused = dilated(clicked, kHeld + kBodyRadius);
  for (std::size_t i = 0; i < body.size(); ++i)
    if (refused.voxels[i] != 0) is_taken[static_cast<std::size_t>(body[i])] = 0;
  Mask left = ct.empty_mask();
  for (std::size_t i = 0; i < body.size(); ++i)
    left.voxels[i] = static_cast<std::uint8_t>(is_taken[static_cast<std::size_t>(body[i])]);
  return left;
}

}  // namespace

Cancellable<Mask> with_enclosed(const Field& ct, const Mask& found, const Tissue& liver, const Mask& like,
                                const Mask& own, const Mask& barred, const Mask& included, const Mask& likely,
                                const LiverSeeds& seeds, const RunContext& context) {
  // What was found of the liver says better how dark it is than a few clicks did, one of them in a cyst.
  const auto darkest = static_cast<float>(liver.mean - kLiverWidth * std::max(liver.sigma, kDrift));
  Mask alike = like;
  for (std::size_t i = 0; i < alike.voxels.size(); ++i)
    if (ct.values[i] < darkest) alike.voxels[i] = 0;
  const Ground ground{ct, liver, like, alike, own, barred, included, likely, seeds, darkest};
  auto whole = parted(ground, found, context);
  for (int round = 0; whole && round < kMostRounds; ++round) {
    const Mask left = left_enclosed(ground, *whole);
    if (left.count() == 0) break;
    unite(*whole, left);
    whole = parted(ground, *whole, context);
  }
  return whole;
}

}  // namespace glisson::segmentation
