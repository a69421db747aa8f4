// SPDX-License-Identifier: GPL-3.0-or-later
#include "vessels.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "glisson/core/share_out.h"
#include "glisson/core/statistics.h"
#include "tree_split.h"

namespace glisson::segmentation {
namespace {

constexpr double kOutside = 10.0;  // mm that a vessel is followed outside the liver
constexpr double kThickest = 9.0;  // mm: the radius from which on something bright is no liver vessel
constexpr double kBodyRim = 3.0;   // mm around what is brighter than any vessel in which it shines through
constexpr double kSmallestTree = 0.2;  // ml below which a piece is noise
/// Brightness of candidates in the liver, of tubular ones, and outside; 0 parenchyma, 1 the clicked vessels.
constexpr double kBright = 0.35, kDim = 0.12, kBrightOutside = 0.6, kTooBright = 1.6, kBodyInside = 2.0;
constexpr double kTubular = 0.05;  // of the same contrast
/// And never less than this many sigmas of the parenchyma: a click on a dim vein must not let noise in.
constexpr double kNoiseBright = 3.4, kNoiseDim = 1.2;
/// Nor than so often what parenchyma reaches in one voxel of twenty: nodules and noise look like short tubes.
constexpr double kNoiseTubular = 2.2, kUsual = 0.95;
/// Sigmas by which a tree's clicks are brighter than the parenchyma, or it is not seen.
constexpr double kLeastSeen = 2.0;
constexpr std::array<double, 3> kScales = {1.2, 2.0, 3.2};  // mm
constexpr double kLevel = 0.1;  // of the contrast: steps of how bright what is broad is
constexpr int kLevels = 5;
constexpr double kTrunkWay = 12.0;  // mm around the straight way from a click outside to the liver

/// Second derivatives by central differences at an inner voxel.
Eigen::Matrix3f hessian(const Field& f, std::size_t at) {
  const std::array<std::ptrdiff_t, 3> s = {
      1, f.size.x(), static_cast<std::ptrdiff_t>(f.size.x()) * static_cast<std::ptrdiff_t>(f.size.y())};
  const float* p = f.values.data() + at;
  Eigen::Matrix3f h;
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) {
      const std::ptrdiff_t sa = s[static_cast<std::size_t>(a)], sb = s[static_cast<std::size_t>(b)];
      const auto scale = static_cast<float>(1.0 / (f.spacing_mm[a] * f.spacing_mm[b]));
      const float d = a == b ? p[sa] - 2.0F * p[0] + p[-sa]
                             : 0.25F * (p[sa + sb] - p[sa - sb] - p[sb - sa] + p[-sa - sb]);
      h(a, b) = h(b, a) = d * scale;
    }
  return h;
}

float tube_response(const Eigen::Matrix3f& h) {
  // Cheap refusal first: a bright tube curves downwards on the whole.
  if (h.trace() >= 0.0F) return 0.0F;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(h, Eigen::EigenvaluesOnly);
  const Eigen::Vector3f lambda = solver.eigenvalues();  // rising
  return lambda[1] < 0.0F ? -lambda[1] : 0.0F;
}

/// A trunk is clicked where it is widest, which may be cm before the liver: the way from there belongs to
/// where it is looked for.
void add_way_to_liver(const Field& ct, const Mask& liver, const Eigen::Vector3i& click, Mask& region) {
  const auto to_click = [&](const Eigen::Vector3i& v) {
    return Eigen::Vector3d((v - click).cast<double>().cwiseProduct(ct.spacing_mm));
  };
  double nearest = kFarthestClick;
  Eigen::Vector3d way = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < liver.voxels.size(); ++i) {
    if (liver.voxels[i] == 0) continue;
    const Eigen::Vector3d d = to_click(ct.voxel_at(i));
    if (d.norm() >= nearest) continue;
    nearest = d.norm();
    way = d;
  }
  if (nearest <= kOutside || nearest >= kFarthestClick) return;
  for (std::size_t i = 0; i < region.voxels.size(); ++i) {
    const Eigen::Vector3d d = to_click(ct.voxel_at(i));
    const double along = std::clamp(d.dot(way) / way.squaredNorm(), 0.0, 1.0);
    if ((d - along * way).squaredNorm() <= kTrunkWay * kTrunkWay) region.voxels[i] = 1;
  }
}

/// Where vessels are looked for: in the liver with its bays and a little around, not in the cava.
Mask search_region(const Field& ct, const Mask& liver, const Mask& cava, const Mask& barred,
                   const VesselSeeds& seeds) {
  Mask region = dilated(closed(liver, 8.0), kOutside);
  for (const auto* clicks : {&seeds.portal, &seeds.hepatic})
    for (const Eigen::Vector3i& click : *clicks) add_way_to_liver(ct, liver, click, region);
  for (std::size_t i = 0; i < region.voxels.size(); ++i)
    if (cava.voxels[i] != 0 || barred.voxels[i] != 0) region.voxels[i] = 0;
  return region;
}

/// Removes what is too thick to be a liver vessel (kidney, aorta, heart, bowel). `bright` goes beyond where
/// vessels are looked for: of a heart only a slice may lie there.
void remove_thick(const Mask& bright, Mask& candidates) {
  const Mask thick = dilated(eroded(bright, kThickest), kThickest + 2.0);
  for (std::size_t i = 0; i < candidates.voxels.size(); ++i)
    if (thick.voxels[i] != 0) candidates.voxels[i] = 0;
}

/// Removes the rims of what is brighter than the clicked vessels (cortex of a kidney, heart, rib, aorta):
/// blurred, a rim is as bright as a vein. Thin arteries have none that matters, and of the liver's own
/// vessels one tree may be much the brighter.
void remove_rims(const Mask& liver, const std::vector<float>& brightness, double brightest,
                 Mask& candidates) {
  Mask body(candidates.size, candidates.spacing_mm);
  for (std::size_t i = 0; i < body.voxels.size(); ++i)
    body.voxels[i] =
        brightness[i] >= static_cast<float>(brightest * (liver.voxels[i] == 0 ? kTooBright : kBodyInside));
  const Mask rim = dilated(opened(body, 1.0), kBodyRim);
  for (std::size_t i = 0; i < rim.voxels.size(); ++i)
    if (rim.voxels[i] != 0) candidates.voxels[i] = 0;
}

/// How bright what is broad is around each voxel, of the contrast above `mean`: a grey-scale opening (of
/// which what is left is the white top hat) by a ball that fits into no vessel of the liver, in steps, at
/// every other voxel. So a heart's blur, a lobe that is perfused more, and the rims of both are no vessels.
std::vector<float> broad_brightness(const Field& ct, double mean, double contrast) {
  constexpr int kEvery = 2;
  Field blurred = ct;
  smooth(blurred, 1.0);
  const Eigen::Vector3i size = (ct.size.array() + kEvery - 1) / kEvery;
  Mask above(size, kEvery * ct.spacing_mm);
  std::vector<float> coarse(above.voxels.size(), 0.0F);
  for (int n = 1; n <= kLevels; ++n) {
    const auto limit = static_cast<float>(mean + n * kLevel * contrast);
    std::size_t at = 0;
    for (int k = 0; k < size.z(); ++k)
      for (int j = 0; j < size.y(); ++j)
        for (int i = 0; i < size.x(); ++i, ++at)
          above.voxels[at] = blurred.values[ct.offset(kEvery * i, kEvery * j, kEvery * k)] > limit ? 1 : 0;
    const Mask broad = opened(above, kThickest);
    for (std::size_t i = 0; i < coarse.size(); ++i)
      if (broad.voxels[i] != 0) coarse[i] = static_cast<float>(n * kLevel);
  }
  std::vector<float> result;
  result.reserve(ct.values.size());
  for (int k = 0; k < ct.size.z(); ++k)
    for (int j = 0; j < ct.size.y(); ++j)
      for (int i = 0; i < ct.size.x(); ++i)
        result.push_back(coarse[above.offset(i / kEvery, j / kEvery, k / kEvery)]);
  return result;
}

/// What darker things beside it make of parenchyma is no tube: fat along the liver's edge, tumours.
Field without_darker(Field ct, const Tissue& parenchyma) {
  for (float& value : ct.values) value = std::max(value, static_cast<float>(parenchyma.mean));
  return ct;
}

/// The tubeness that parenchyma has by itself.
double usual_tubeness(const Field& ct, const Mask& liver, const Tissue& parenchyma,
                      const std::vector<float>& tubes) {
  std::vector<float> usual;
  usual.reserve(tubes.size() / 4);
  for (std::size_t i = 0; i < tubes.size(); ++i)
    if (liver.voxels[i] != 0 && std::abs(ct.values[i] - parenchyma.mean) < 2.0 * parenchyma.sigma)
      usual.push_back(tubes[i]);
  return usual.empty() ? 0.0 : static_cast<double>(lower_percentile(std::move(usual), kUsual));
}

/// The nearest candidate to each click.
std::vector<std::size_t> snapped(const Field& ct, const Mask& candidates,
                                 const std::vector<Eigen::Vector3i>& clicks) {
  const int reach = static_cast<int>(std::ceil(kBesideVessel / ct.spacing_mm.minCoeff()));
  std::vector<std::size_t> places;
  for (const Eigen::Vector3i& click : clicks) {
    double best = kBesideVessel;
    std::ptrdiff_t place = -1;
    for (int k = -reach; k <= reach; ++k)
      for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) {
          const Eigen::Vector3i v = click + Eigen::Vector3i(i, j, k);
          const double d = Eigen::Vector3d(i, j, k).cwiseProduct(ct.spacing_mm).norm();
          if (d > best || !ct.contains(v) || candidates.voxels[ct.offset(v)] == 0) continue;
          best = d;
          place = static_cast<std::ptrdiff_t>(ct.offset(v));
        }
    if (place >= 0) places.push_back(static_cast<std::size_t>(place));
  }
  return places;
}

Mask pieces_of(const Field& ct, const std::vector<Owner>& owner, Owner who) {
  Mask mask = ct.empty_mask();
  for (std::size_t i = 0; i < owner.size(); ++i) mask.voxels[i] = owner[i] == who ? 1 : 0;
  std::vector<long> sizes;
  const std::vector<int> number = connected_components(mask, sizes);
  const double voxel_ml = 1e-3 * ct.spacing_mm.prod();
  for (std::size_t i = 0; i < owner.size(); ++i)
    if (number[i] > 0 &&
        static_cast<double>(sizes[static_cast<std::size_t>(number[i]) - 1]) * voxel_ml < kSmallestTree)
      mask.voxels[i] = 0;
  return mask;
}

/// How much brighter than the parenchyma the clicks are, HU.
double brighter_by(const Field& ct, const std::vector<Eigen::Vector3i>& clicks, const Tissue& parenchyma) {
  return tissue_around(ct, clicks, 2.0, 1.0, 50.0).mean - parenchyma.mean;
}

/// A tree's clicks, unless nothing tells it from the parenchyma. @param is_faint set where it is not bright
/// enough to be a candidate by itself.
std::vector<Eigen::Vector3i> seen(const Field& ct, const std::vector<Eigen::Vector3i>& clicks,
                                  const Tissue& parenchyma, bool& is_faint) {
  if (clicks.empty()) return {};
  const double brighter = brighter_by(ct, clicks, parenchyma);
  is_faint = brighter < kNoiseBright * parenchyma.sigma;
  return brighter < kLeastSeen * parenchyma.sigma ? std::vector<Eigen::Vector3i>{} : clicks;
}

}  // namespace

Cancellable<std::vector<float>> tubeness(const Field& ct, const Mask& where,
                                         const std::vector<double>& sigmas_mm, const RunContext& context) {
  std::vector<float> best(ct.values.size(), 0.0F);
  for (std::size_t n = 0; n < sigmas_mm.size(); ++n) {
    if (context.cancelled()) return std::nullopt;
    context.progress(static_cast<double>(n) / static_cast<double>(sigmas_mm.size()),
                     "segmentation.vesselness");
    Field blurred = ct;
    smooth(blurred, sigmas_mm[n]);
    const auto scale = static_cast<float>(sigmas_mm[n] * sigmas_mm[n]);
    const auto inner_slices = static_cast<std::size_t>(std::max(0, ct.size.z() - 2));
    const auto slice = static_cast<std::size_t>(ct.size.x()) * static_cast<std::size_t>(ct.size.y());
    share_out_runs(inner_slices, least_run(slice), [&](std::size_t first, std::size_t end) {
      for (int k = 1 + static_cast<int>(first); k < 1 + static_cast<int>(end); ++k)
        for (int j = 1; j + 1 < ct.size.y(); ++j)
          for (int i = 1; i + 1 < ct.size.x(); ++i) {
            const std::size_t at = ct.offset(i, j, k);
            if (where.voxels[at] != 0)
              best[at] = std::max(best[at], scale * tube_response(hessian(blurred, at)));
          }
    });
  }
  return best;
}

Cancellable<Vessels> find_vessels(const Field& ct, const Mask& liver, const Mask& cava, const Mask& barred,
                                  const Tissue& parenchyma, const VesselSeeds& clicked,
                                  const RunContext& context) {
  Vessels vessels{ct.empty_mask(), ct.empty_mask()};
  const VesselSeeds seeds{seen(ct, clicked.portal, parenchyma, vessels.portal_is_faint),
                          seen(ct, clicked.hepatic, parenchyma, vessels.hepatic_is_faint), clicked.from_cava};
  if (seeds.portal.empty() && seeds.hepatic.empty()) return vessels;
  const Mask region = search_region(ct, liver, cava, barred, seeds);
  const auto tubes = tubeness(without_darker(ct, parenchyma), region,
                              std::vector<double>(kScales.begin(), kScales.end()), context.part(0.0, 0.6));
  if (!tubes) return std::nullopt;

  std::vector<Eigen::Vector3i> all = seeds.portal;
  all.insert(all.end(), seeds.hepatic.begin(), seeds.hepatic.end());
  const double contrast = std::max(brighter_by(ct, all, parenchyma), 3.0 * parenchyma.sigma);
  // Nothing as bright as the clicks of one tree is too bright for it, though the other's are fainter.
  double brightest = 1.0;
  for (const auto* clicks : {&seeds.portal, &seeds.hepatic})
    if (!clicks->empty()) brightest = std::max(brightest, brighter_by(ct, *clicks, parenchyma) / contrast);
  const double noise = parenchyma.sigma / contrast;
  const double least_bright = std::max(kBright, kNoiseBright * noise);
  const double least_dim = std::max(kDim, kNoiseDim * noise);
  const double least_tubular =
      std::max(kTubular, kNoiseTubular * usual_tubeness(ct, liver, parenchyma, *tubes) / contrast);
  const std::vector<float> broad = broad_brightness(ct, parenchyma.mean, contrast);
  Mask candidates = ct.empty_mask(), everything_bright = candidates;
  std::vector<float> brightness(ct.values.size(), 0.0F);
  for (std::size_t i = 0; i < candidates.voxels.size(); ++i) {
    const double bright = (ct.values[i] - parenchyma.mean) / contrast;
    everything_bright.voxels[i] = bright > kBrightOutside;
    brightness[i] = static_cast<float>(bright);
    if (region.voxels[i] == 0) continue;
    const double tube = (*tubes)[i] / contrast;
    // Thick vessels are bright without looking like tubes; thin ones look like tubes but are dimmed by blur.
    // Outside the liver, where other bright things lie, only what is as bright as the clicks counts.
    const bool in = liver.voxels[i] != 0;
    const double above = bright - static_cast<double>(broad[i]);
    candidates.voxels[i] = in ? (above > least_bright || (above > least_dim && tube > least_tubular))
                              : (bright > kBrightOutside && bright < brightest * kTooBright);
  }
  remove_thick(everything_bright, candidates);
  remove_rims(liver, brightness, brightest, candidates);
  if (context.cancelled()) return std::nullopt;
  context.progress(0.7, "segmentation.trees");

  std::vector<std::size_t> hepatic = snapped(ct, candidates, seeds.hepatic);
  const std::vector<std::size_t> portal = snapped(ct, candidates, seeds.portal);
  // The hepatic veins drain into the cava: its wall is a source of theirs.
  const Mask wall = dilated(cava, 1.5 * ct.spacing_mm.maxCoeff());
  for (std::size_t i = 0; i < wall.voxels.size(); ++i)
    if (seeds.from_cava && !seeds.hepatic.empty() && wall.voxels[i] != 0 && candidates.voxels[i] != 0 &&
        liver.voxels[i] != 0)
      hepatic.push_back(i);
  const auto owner = split_trees(ct, candidates, brightness, portal, hepatic, context);
  if (!owner) return std::nullopt;
  vessels.portal = pieces_of(ct, *owner, Owner::portal);
  vessels.hepatic = pieces_of(ct, *owner, Owner::hepatic);
  return vessels;
}

}  // namespace glisson::segmentation
