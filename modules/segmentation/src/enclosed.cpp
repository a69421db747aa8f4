// SPDX-License-Identifier: GPL-3.0-or-later
#include "enclosed.h"

#include <algorithm>
#include <cmath>

#include "bites.h"
#include "region_cut.h"

namespace glisson::segmentation {
namespace {

constexpr double kDeep = 4.0;    // mm below the border of the liver found so far
constexpr float kFluid = 25.0F;  // HU below which a body at the rim may be a gallbladder or ascites
constexpr double kSight = 80.0;  // mm
/// Per mm: what was found; what looks unlike the liver, by how much of it is enclosed; what is brighter, as
/// vessels and kidneys are; and what is fluid.
constexpr float kFound = 0.1F, kEnclosing = 0.1F, kLeastUnlike = -0.01F, kMostUnlike = 0.03F,
                kBright = -0.01F, kUnlikeFluid = -0.1F;

/// A way from a voxel, a voxel's width at a time, and the solid angle that it stands for, of 1.
struct Way {
  Eigen::Vector3d step;
  int most_steps;
  double share;
};

/// Ways to all sides: to the surface of the cube of five voxels around one.
std::vector<Way> ways_in(const Field& ct) {
  std::vector<Way> ways;
  double sum = 0.0;
  for (int k = -2; k <= 2; ++k)
    for (int j = -2; j <= 2; ++j)
      for (int i = -2; i <= 2; ++i) {
        if (std::max({std::abs(i), std::abs(j), std::abs(k)}) < 2) continue;
        const Eigen::Vector3d step = 0.5 * Eigen::Vector3d(i, j, k);
        const double mm = step.cwiseProduct(ct.spacing_mm).norm();
        ways.push_back({step, static_cast<int>(kSight / mm), 1.0 / (mm * mm * mm)});
        sum += ways.back().share;
      }
  for (Way& way : ways) way.share /= sum;
  return ways;
}

/// The part of what is seen from a voxel that is liver, with nothing empty before it. Within a body that the
/// liver encloses it is more than one half; beside a flat side of the liver less.
double enclosed_share(const Field& ct, const Mask& liver, const std::vector<Way>& ways, std::size_t from) {
  const Eigen::Vector3d start = ct.voxel_at(from).cast<double>();
  double share = 0.0;
  for (const Way& way : ways)
    for (int n = 1; n <= way.most_steps; ++n) {
      const Eigen::Vector3i v = (start + n * way.step).array().round().matrix().cast<int>();
      if (!ct.contains(v) || ct.values[ct.offset(v)] < kEmptyTissue) break;
      if (liver.voxels[ct.offset(v)] == 0) continue;
      share += way.share;
      break;
    }
  return share;
}

}  // namespace

Cancellable<Mask> with_enclosed(const Field& ct, const Mask& found, const Tissue& liver, const Mask& like,
                                const Mask& own, const Mask& barred, const Mask& included, const Mask& likely,
                                const LiverSeeds& seeds, const RunContext& context) {
  Mask open = with_bites(found);
  if (context.cancelled()) return std::nullopt;
  const Mask deep = eroded(found, kDeep);
  const std::vector<Way> ways = ways_in(ct);
  const auto unlike = [&](std::size_t at) {
    if (ct.values[at] < kFluid) return kUnlikeFluid;
    const float most = ct.values[at] > static_cast<float>(liver.mean) ? kBright : kMostUnlike;
    const double beyond_half = enclosed_share(ct, found, ways, at) - 0.5;
    return std::clamp(kEnclosing * static_cast<float>(beyond_half), kLeastUnlike, most);
  };
  std::vector<float> reward(open.voxels.size(), 0.0F);
  for (std::size_t i = 0; i < reward.size(); ++i) {
    if (found.voxels[i] != 0 || likely.voxels[i] != 0)
      reward[i] = kFound;
    else if (like.voxels[i] == 0 && open.voxels[i] != 0)
      reward[i] = unlike(i);
    if (deep.voxels[i] != 0 || included.voxels[i] != 0) reward[i] = kKnown;
    const bool parted = like.voxels[i] != 0 && own.voxels[i] == 0 && reward[i] == 0.0F;
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
