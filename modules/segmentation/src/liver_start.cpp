// SPDX-License-Identifier: GPL-3.0-or-later
#include "liver_start.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "bites.h"
#include "fronts.h"
#include "painting.h"
#include "parting.h"
#include "sight.h"

namespace glisson::segmentation {
namespace {

constexpr double kNeck = 6.0;       // mm, half the width of the passages that the start closes
constexpr double kSeamWidth = 2.2;  // of the widest tissue
constexpr double kSeamTypical = 10.0, kSeamDepth = 5.0;  // mm around a click; below the surface
constexpr double kSeamClosed = 2.0;                      // mm
constexpr int kStartRounds = 2;
constexpr double kBetween = 0.6, kOfEither = 0.1;  // of the view, within what two bodies enclose
constexpr double kTumour = 4.0;                    // mm, half the width of a tumour that narrows a neck

/// Tissue that could be liver: near its intensity, and the bright vessels enclosed by it.
Mask liver_like(const Field& ct, const Tissue& tissue, double width, const Mask& barred,
                const Mask& included) {
  Mask mask = ct.empty_mask();
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    mask.voxels[i] = std::abs(ct.values[i] - tissue.mean) < width * tissue.sigma || included.voxels[i] != 0;
  const Mask around = closed(mask, kVesselWidth);
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    if (around.voxels[i] != 0 && ct.values[i] > tissue.mean && ct.values[i] < tissue.mean + 130.0)
      mask.voxels[i] = 1;
    if (barred.voxels[i] != 0) mask.voxels[i] = 0;
  }
  return mask;
}

/// A mask of one grid on another one of the same image: the nearest voxel counts, beyond its edge 0.
Mask nearest(const Mask& mask, const Field& from, const Field& to) {
  Mask result = to.empty_mask();
  std::array<std::vector<int>, 3> at;
  for (int axis = 0; axis < 3; ++axis)
    for (int n = 0; n < to.size[axis]; ++n)
      at[static_cast<std::size_t>(axis)].push_back(static_cast<int>(std::lround(
          (to.first_index[axis] + n * to.step[axis] - from.first_index[axis]) / from.step[axis])));
  std::size_t voxel = 0;
  for (int k = 0; k < to.size.z(); ++k)
    for (int j = 0; j < to.size.y(); ++j)
      for (int i = 0; i < to.size.x(); ++i, ++voxel) {
        const Eigen::Vector3i v(at[0][static_cast<std::size_t>(i)], at[1][static_cast<std::size_t>(j)],
                                at[2][static_cast<std::size_t>(k)]);
        if (from.contains(v)) result.voxels[voxel] = mask.voxels[from.offset(v)];
      }
  return result;
}

/// Places of one grid on another one of the same image; those beside it are dropped.
std::vector<Eigen::Vector3i> moved(const std::vector<Eigen::Vector3i>& places, const Field& from,
                                   const Field& to) {
  std::vector<Eigen::Vector3i> result;
  for (const Eigen::Vector3i& p : places) {
    const Eigen::Vector3i v = to.voxel_of(from.first_index + p.cast<double>().cwiseProduct(from.step));
    if (to.contains(v)) result.push_back(v);
  }
  return result;
}

/// What may be a seam between organs, on the parting's voxels.
DarkSheets sheets_of(const PartingView& view, const Tissue& tissue) {
  Mask where = view.ct.empty_mask();
  const auto width = static_cast<float>(kSeamWidth * kMostLiverSigma);
  for (std::size_t i = 0; i < where.voxels.size(); ++i)
    where.voxels[i] = std::abs(view.ct.values[i] - static_cast<float>(tissue.mean)) < width;
  return {view.raw, where};
}

/// Around the clicks: tissue without seams, as long as no more is known.
Mask around(const Field& field, const std::vector<Eigen::Vector3i>& clicks) {
  Mask places = field.empty_mask();
  for (const Eigen::Vector3i& p : clicks) places.voxels[field.offset(p)] = 1;
  return dilated(places, kSeamTypical);
}

/// What lies within what was found: far more than some clicks' surroundings, one of which may hold a fissure.
/// Its seams are closed first: without what they held the limit would fall from round to round.
Mask within(const LiverStart& found, const Field& ct, const PartingView& view) {
  Mask inner = nearest(closed(found.own, kSeamDepth), ct, view.ct);
  const std::vector<float> depth2 = squared_depth_mm2(inner);
  for (std::size_t i = 0; i < inner.voxels.size(); ++i)
    inner.voxels[i] = depth2[i] > static_cast<float>(kSeamDepth * kSeamDepth);
  return inner;
}

/// Where the contour starts: what the clicks inside own of the tissue that is wider than a neck.
Cancellable<LiverStart> start_of(const Field& ct, const PartingView& view, const Tissue& tissue,
                                 const Mask& seams, const LiverSeeds& seeds, const LiverSeeds& view_seeds,
                                 const Mask& barred, const Mask& included, const Mask& likely,
                                 const RunContext& context) {
  Mask lesions = included;
  for (std::size_t i = 0; i < lesions.voxels.size(); ++i)
    if (likely.voxels[i] != 0) lesions.voxels[i] = 1;
  Mask parted =
      liver_like(view.ct, tissue, kLiverWidth, nearest(barred, ct, view.ct), nearest(lesions, ct, view.ct));
  for (std::size_t i = 0; i < parted.voxels.size(); ++i)
    if (seams.voxels[i] != 0) parted.voxels[i] = 0;
  const auto sides = part_at_necks(view.ct, parted, view_seeds, context);
  if (!sides) return std::nullopt;
  LiverStart result;
  result.doubtful = {sides->doubtful_ml,
                     view.ct.first_index + sides->doubtful.cast<double>().cwiseProduct(view.ct.step)};
  result.perhaps = nearest(sides->perhaps, view.ct, ct);
  result.open = liver_like(ct, tissue, kLiverWidth, barred, included);
  result.rival = nearest(sides->rival, view.ct, ct);
  Mask own = closed(nearest(sides->own, view.ct, ct), kSeamClosed);
  for (std::size_t i = 0; i < own.voxels.size(); ++i)
    if (result.open.voxels[i] == 0 || result.rival.voxels[i] != 0) own.voxels[i] = 0;
  // Where no neck parts a click outside from those inside, fronts from both meet half way.
  const std::vector<float> depth2 = squared_depth_mm2(own);
  LiverSeeds within;
  for (const Eigen::Vector3i& p : seeds.inside)
    if (own.voxels[ct.offset(p)] != 0) within.inside.push_back(p);
  for (const Eigen::Vector3i& p : seeds.outside)
    if (own.voxels[ct.offset(p)] != 0) within.outside.push_back(p);
  std::vector<std::uint8_t> owner(own.voxels.size(), 1);
  if (!within.outside.empty() && !within.inside.empty())
    owner = first_to_reach(own, depth2, {within.inside, within.outside});
  Mask core = ct.empty_mask();
  for (std::size_t i = 0; i < core.voxels.size(); ++i) {
    if (own.voxels[i] != 0 && owner[i] == 2) result.rival.voxels[i] = 1;
    if (owner[i] != 1) own.voxels[i] = 0;
    core.voxels[i] = own.voxels[i] != 0 && depth2[i] > static_cast<float>(kNeck * kNeck);
  }
  for (const Eigen::Vector3i& p : seeds.inside) core.voxels[ct.offset(p)] = 1;
  result.start = dilated(core, kNeck);
  for (std::size_t i = 0; i < core.voxels.size(); ++i)
    if (own.voxels[i] == 0) result.start.voxels[i] = 0;
  for (const Eigen::Vector3i& p : seeds.inside) result.start.voxels[ct.offset(p)] = 1;
  result.own = std::move(own);
  return result;
}

/// Dark soft tissue that the liver and a body which may be a part of it enclose together: a tumour between
/// them, most likely. Beside a stomach that lies against the liver and another organ less of the view is
/// theirs.
Mask between(const Field& ct, const Tissue& tissue, const LiverStart& start) {
  Mask both = start.own;
  for (std::size_t i = 0; i < both.voxels.size(); ++i)
    if (start.perhaps.voxels[i] != 0) both.voxels[i] = 2;
  const Mask hull = with_bites(both);
  const Sight sight(ct, both);
  const auto most = static_cast<float>(tissue.mean);
  Mask dark = ct.empty_mask();
  for (std::size_t i = 0; i < dark.voxels.size(); ++i) {
    if (hull.voxels[i] == 0 || both.voxels[i] != 0 || !(ct.values[i] > kEmptyTissue && ct.values[i] < most))
      continue;
    const auto [liver, body] = sight.shares(i);
    dark.voxels[i] = liver + body > kBetween && std::min(liver, body) > kOfEither;
  }
  return opened(dark, kTumour);
}

}  // namespace

Cancellable<LiverStart> find_start(const Field& ct, const PartingView& view, const LiverSeeds& seeds,
                                   const Mask& barred, const Mask& included, const Mask& likely,
                                   const RunContext& context) {
  Tissue tissue = liver_at(ct, seeds.inside);
  Tissue parenchyma = tissue;
  const auto learn_from = [&](const LiverStart& found) {
    const Tissue seen = tissue_within(ct, found.start, 4.0);
    if (!(seen.sigma > 0.0)) return;
    parenchyma = seen;
    // The whole liver differs more than what was found of it.
    tissue = {seen.mean, std::max(seen.sigma, tissue.sigma)};
  };
  const LiverSeeds view_seeds{moved(seeds.inside, ct, view.ct), moved(seeds.outside, ct, view.ct),
                              moved(seeds.lesions, ct, view.ct)};
  DarkSheets sheets = sheets_of(view, tissue);
  sheets.learn(around(view.ct, view_seeds.inside));
  Mask seams = sheets.sheets();
  LiverStart parted;
  for (int round = 0; round < kStartRounds; ++round) {
    if (context.cancelled()) return std::nullopt;
    context.progress(static_cast<double>(round) / kStartRounds, "segmentation.start");
    auto next = start_of(ct, view, tissue, seams, seeds, view_seeds, barred, included, likely, context);
    if (!next) return std::nullopt;
    parted = std::move(*next);
    learn_from(parted);
    sheets.learn(within(parted, ct, view));
    seams = sheets.sheets();
  }
  if (parted.doubtful.ml > 0.0) {
    // A tumour is no neck, though nobody has clicked it.
    Mask tumours = between(ct, tissue, parted);
    for (std::size_t i = 0; i < tumours.voxels.size(); ++i)
      if (likely.voxels[i] != 0) tumours.voxels[i] = 1;
    auto again = start_of(ct, view, tissue, seams, seeds, view_seeds, barred, included, tumours, context);
    if (!again) return std::nullopt;
    long taken = 0;
    for (std::size_t i = 0; i < tumours.voxels.size(); ++i)
      taken += parted.perhaps.voxels[i] != 0 && again->own.voxels[i] != 0;
    if (2 * taken > parted.perhaps.count()) {
      // Its grey may be why it was left out: what its statistics add is the liver's, too.
      learn_from(*again);
      auto more = start_of(ct, view, tissue, seams, seeds, view_seeds, barred, included, tumours, context);
      if (!more) return std::nullopt;
      parted = std::move(more->own.count() > again->own.count() ? *more : *again);
    }
  }
  parted.parenchyma = parenchyma;
  return parted;
}

}  // namespace glisson::segmentation
