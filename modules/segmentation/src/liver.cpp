// SPDX-License-Identifier: GPL-3.0-or-later
#include "liver.h"

#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"
#include "intensity_ratio.h"
#include "level_set.h"
#include "painting.h"

namespace glisson::segmentation {
namespace {

constexpr double kRivalRim = 2.0;       // mm
constexpr double kReach = 8.0;          // mm that the contour may go beyond its start
constexpr double kCurvature = 3.0;      // mm
constexpr double kLastCurvature = 0.5;  // mm: more of it eats sharp edges
/// New samples of both sides each round: the contour comes from 3 mm inside.
constexpr int kLastRounds = 4, kLastSteps = 20;
constexpr int kFineRounds = 3, kFineSteps = 24;
constexpr float kFineReach = 3.0F;         // mm that a contour may leave one that had come to rest
constexpr double kWedge = 6.0;             // mm, half the width of what may be a margin of the liver
constexpr double kWedgeLength = 20.0;      // mm that the last contours may follow it
constexpr double kHalfWayToMuscle = 25.0;  // HU below the liver
constexpr double kBorder = 5.0;            // mm that they may go elsewhere
constexpr double kPartialVolume = 3.0;     // mm beyond liver-like tissue
constexpr double kAttraction = 1.5;        // mm
constexpr double kEdgeScale = 6.0;         // HU/mm at which an edge halves the edge map

Field edge_map(const Field& ct) {
  Field edge = ct;
  const std::vector<float> gradient = gradient_magnitude(ct);
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    const float r = gradient[i] / static_cast<float>(kEdgeScale);
    edge.values[i] = 1.0F / (1.0F + r * r);
  }
  return edge;
}

/// What the contour works on: the surroundings of the start.
struct Scene {
  Field ct;
  Mask open, start, barred, included, own;
  std::vector<Eigen::Vector3i> outside;
};

void impose(Field& region, const Scene& scene) {
  for (std::size_t i = 0; i < region.values.size(); ++i) {
    if (scene.included.voxels[i] != 0) region.values[i] = 1.0F;
    if (scene.barred.voxels[i] != 0) region.values[i] = -1.0F;
  }
  for (const Eigen::Vector3i& p : scene.outside) region.values[region.offset(p)] = -1.0F;
}

/// Weakens the region force on strong edges, so that the contour comes to rest where the edge is steepest,
/// half way between the two tissues.
void quieten_on_edges(Field& region, const Field& edge) {
  for (std::size_t i = 0; i < region.values.size(); ++i) region.values[i] *= edge.values[i];
}

/// Likelihood ratio of the intensities inside the contour to those in a rim around it.
IntensityRatio ratio_of(const Field& ct, const Field& phi, double rim_mm) {
  IntensityHistogram in, out;
  for (std::size_t i = 0; i < ct.values.size(); ++i) {
    const float d = phi.values[i];
    if (d < -2.0F) in.add(ct.values[i]);
    if (d > 2.0F && d < rim_mm) out.add(ct.values[i]);
  }
  return {in, out};
}

/// The last region force, from the tissue close by on either side (Lankton and Tannenbaum 2008). With it the
/// contour comes to rest half way between the liver and whatever lies beside it there, be it fat, muscle or
/// lung. It is 0 where both sides look alike.
void local_region(const Field& ct, const Field& phi, Field& region) {
  constexpr float kNear = 1.5F, kFar = 6.0F;  // mm from the contour, where the two sides are sampled
  constexpr double kWindow = 4.0;             // mm
  // What is emptier than fat is lung or gas, and a diaphragm or a wall lies before it.
  constexpr float kEmpty = -150.0F, kWall = 50.0F;  // HU
  constexpr float kContrast = 15.0F;                // HU below which the sides are alike
  Field in = ct.filled(0.0F), in_weight = in, out = in, out_weight = in;
  for (std::size_t i = 0; i < ct.values.size(); ++i) {
    const float d = phi.values[i];
    if (d < -kNear && d > -kFar) in.values[i] = ct.values[i], in_weight.values[i] = 1.0F;
    if (d > kNear && d < kFar) {
      out.values[i] = ct.values[i] > kEmpty ? ct.values[i] : kWall;
      out_weight.values[i] = 1.0F;
    }
  }
  for (Field* field : {&in, &in_weight, &out, &out_weight}) smooth(*field, kWindow);
  for (std::size_t i = 0; i < ct.values.size(); ++i) {
    region.values[i] = 0.0F;
    if (in_weight.values[i] < 1e-3F || out_weight.values[i] < 1e-3F) continue;
    const float inner = in.values[i] / in_weight.values[i], outer = out.values[i] / out_weight.values[i];
    const float contrast = inner - outer;
    if (std::abs(contrast) < kContrast) continue;
    region.values[i] = std::clamp(2.0F * (ct.values[i] - 0.5F * (inner + outer)) / contrast, -1.0F, 1.0F);
    // What is beyond both sides (a vessel, a lesion within the liver) is no reason to move.
    if (contrast > 0.0F && ct.values[i] > inner) region.values[i] = 1.0F;
  }
}

/// How far the last contours may go outwards.
struct Reach {
  double border_mm = kBorder, wedge_mm = kWedgeLength;
};

/// Where the last contours must not go: farther from liver-like tissue than its partial volume reaches, and
/// farther than reach.border_mm from where the second contour came to rest (some 3 mm inside the boundary).
/// Only into thin wedges of the liver's own tissue may they go on, up to reach.wedge_mm: something so thin
/// with fat or gas on both sides is a margin. A stomach or a muscle that touches the liver is thick together
/// with it, or is not its own.
Mask out_of_bounds(const Scene& scene, const Tissue& tissue, const Field& phi, const Reach& reach) {
  Mask found = scene.ct.empty_mask();
  for (std::size_t i = 0; i < found.voxels.size(); ++i) found.voxels[i] = phi.values[i] < 0.0F ? 1 : 0;
  // Half way to muscle and as far above: wider than the start's window, which cuts the border's own tail.
  // Brighter is kidney, cava, portal trunk: the liver's own vessels are within the contour or what it
  // encloses.
  const auto width = static_cast<float>(std::max(kHalfWayToMuscle, kLiverWidth * tissue.sigma));
  const auto mean = static_cast<float>(tissue.mean);
  Mask like = found;
  for (std::size_t i = 0; i < like.voxels.size(); ++i)
    if (scene.open.voxels[i] != 0 || std::abs(scene.ct.values[i] - mean) < width) like.voxels[i] = 1;
  const Mask thick = opened(like, kWedge), near = dilated(like, kPartialVolume);
  const std::vector<float> distance2 = squared_distance_mm2(found);
  const auto border2 = static_cast<float>(reach.border_mm * reach.border_mm),
             length2 = static_cast<float>(reach.wedge_mm * reach.wedge_mm);
  Mask barred = scene.ct.empty_mask();
  for (std::size_t i = 0; i < barred.voxels.size(); ++i)
    barred.voxels[i] = near.voxels[i] == 0 || distance2[i] > length2 ||
                       (distance2[i] > border2 && (thick.voxels[i] != 0 || scene.own.voxels[i] == 0));
  return barred;
}

/// The rounds that settle half way between the liver and what lies beside it. False: cancelled.
bool run_last_rounds(const Scene& scene, const Tissue& tissue, const Reach& reach, Field& phi,
                     ContourForces& forces, const RunContext& context, const ShowContour& show) {
  forces.attraction_mm = 0.0;
  forces.curvature_mm = kLastCurvature;
  const Mask closed_ground = out_of_bounds(scene, tissue, phi, reach);
  for (int round = 0; round < kLastRounds; ++round) {
    local_region(scene.ct, phi, forces.region);
    for (std::size_t i = 0; i < phi.values.size(); ++i)
      if (closed_ground.voxels[i] != 0) forces.region.values[i] = -1.0F;
    impose(forces.region, scene);
    const double done = static_cast<double>(round) / kLastRounds;
    if (!evolve(phi, forces, kLastSteps, context.part(done, done + 1.0 / kLastRounds), show)) return false;
  }
  return true;
}

/// A contour of a box, on the whole grid; far outside elsewhere.
Field on_grid_of(const Field& ct, const Field& phi, const VoxelBox& box) {
  Field whole = ct.filled(static_cast<float>(kReach));
  for (int k = 0; k < phi.size.z(); ++k)
    for (int j = 0; j < phi.size.y(); ++j)
      std::copy_n(
          phi.values.begin() + static_cast<std::ptrdiff_t>(phi.offset(0, j, k)), phi.size.x(),
          whole.values.begin() + static_cast<std::ptrdiff_t>(ct.offset(box.low + Eigen::Vector3i(0, j, k))));
  return whole;
}

/// The contours, from the start to the boundary. Empty when cancelled.
Cancellable<Field> run_contours(const Scene& scene, const Tissue& tissue, const RunContext& context,
                                const ShowContour& show) {
  const Field& ct = scene.ct;
  Field phi = signed_distance(scene.start, ct);
  ContourForces forces;
  forces.curvature_mm = kCurvature;
  forces.attraction_mm = kAttraction;
  forces.edge = edge_map(ct);
  forces.region = ct;
  const auto reach = static_cast<float>(kReach);
  const Field from_start = phi;
  const auto bound = [&] {
    quieten_on_edges(forces.region, forces.edge);
    for (std::size_t i = 0; i < ct.values.size(); ++i)
      if (from_start.values[i] > reach) forces.region.values[i] = -1.0F;
    impose(forces.region, scene);
  };
  for (std::size_t i = 0; i < ct.values.size(); ++i) {
    const double z = (ct.values[i] - tissue.mean) / (kLiverWidth * tissue.sigma);
    forces.region.values[i] =
        scene.open.voxels[i] != 0 ? 1.0F : static_cast<float>(std::clamp(1.0 - z * z, -1.0, 1.0));
  }
  bound();
  if (!evolve(phi, forces, 48, context.part(0.0, 0.4), show)) return std::nullopt;

  const IntensityRatio ratio = ratio_of(ct, phi, 12.0);
  for (std::size_t i = 0; i < ct.values.size(); ++i)
    forces.region.values[i] = std::clamp(0.5F * ratio(ct.values[i]), -1.0F, 1.0F);
  bound();
  if (!evolve(phi, forces, 80, context.part(0.4, 0.7), show)) return std::nullopt;

  if (!run_last_rounds(scene, tissue, {}, phi, forces, context.part(0.7, 1.0), show)) return std::nullopt;
  return phi;
}

}  // namespace

Cancellable<LiverContour> find_liver(const Field& ct, const PartingView& view, const LiverSeeds& seeds,
                                     const Mask& barred, const Mask& included, const Mask& likely,
                                     const RunContext& context, const ShowContour& show) {
  require(!seeds.inside.empty(), "the liver has at least one seed");
  LiverContour result;
  auto parted = find_start(ct, view, seeds, barred, included, likely, context.part(0.0, 0.3));
  if (!parted) return std::nullopt;
  result.parenchyma = parted->parenchyma;
  Mask &open = parted->open, &start = parted->start, &rival = parted->rival;
  // What belongs to others is closed to the contour, a rim of it aside: where they were parted was a guess.
  Mask never = barred;
  const Mask deep = eroded(rival, kRivalRim);
  for (std::size_t i = 0; i < never.voxels.size(); ++i)
    if (deep.voxels[i] != 0) never.voxels[i] = 1;
  // From here on only the surroundings of the start matter.
  const VoxelBox box = bounding_box(ct.size, ct.spacing_mm, start.voxels, kReach + 16.0);
  const auto cut = [&](const Mask& mask) { return crop(ct.size, ct.spacing_mm, mask.voxels, box); };
  Scene scene{ct.cropped(box), cut(open), cut(start), cut(never), cut(included), cut(parted->own), {}};
  for (const Eigen::Vector3i& p : seeds.outside)
    if (scene.ct.contains(p - box.low)) scene.outside.push_back(p - box.low);
  const auto phi = run_contours(scene, result.parenchyma, context.part(0.3, 1.0), show);
  if (!phi) return std::nullopt;
  result.phi = on_grid_of(ct, *phi, box);
  result.like = std::move(open);
  result.own = std::move(parted->own);
  result.closed_ground = std::move(never);
  result.doubtful = parted->doubtful;
  return result;
}

Cancellable<Field> settle_liver(const Field& ct, const Mask& whole, const LiverContour& contour,
                                const LiverSeeds& seeds, const Mask& included, const RunContext& context,
                                const ShowContour& show) {
  const VoxelBox box = bounding_box(ct.size, ct.spacing_mm, whole.voxels, kReach + 16.0);
  const auto cut = [&](const Mask& mask) { return crop(ct.size, ct.spacing_mm, mask.voxels, box); };
  Scene scene{ct.cropped(box), cut(contour.like), cut(whole), cut(contour.closed_ground),
              cut(included),   cut(contour.own),  {}};
  for (const Eigen::Vector3i& p : seeds.outside)
    if (scene.ct.contains(p - box.low)) scene.outside.push_back(p - box.low);
  const Mask deep = eroded(scene.start, kBorder);
  for (std::size_t i = 0; i < deep.voxels.size(); ++i)
    if (deep.voxels[i] != 0) scene.included.voxels[i] = 1;
  Field phi = signed_distance(scene.start, scene.ct);
  ContourForces forces;
  forces.edge = scene.ct.filled(1.0F);
  forces.region = scene.ct;
  if (!run_last_rounds(scene, contour.parenchyma, {kFineReach, kFineReach}, phi, forces, context, show))
    return std::nullopt;
  return on_grid_of(ct, phi, box);
}

Cancellable<Field> refine_liver(const Field& ct, const Field& from, const LiverSeeds& seeds,
                                const Mask& barred, const Mask& included, const RunContext& context,
                                const ShowContour& show) {
  const Field start = interpolated(from, ct);
  Field phi = start;
  ContourForces forces;
  forces.attraction_mm = 0.0;
  forces.curvature_mm = kLastCurvature;
  forces.edge = ct.filled(1.0F);
  forces.region = ct;
  const Scene scene{ct, {}, {}, barred, included, {}, seeds.outside};
  for (int round = 0; round < kFineRounds; ++round) {
    local_region(ct, phi, forces.region);
    for (std::size_t i = 0; i < ct.values.size(); ++i)
      if (std::abs(start.values[i]) > kFineReach)
        forces.region.values[i] = start.values[i] < 0.0F ? 1.0F : -1.0F;
    impose(forces.region, scene);
    const double from_part = static_cast<double>(round) / kFineRounds;
    if (!evolve(phi, forces, kFineSteps, context.part(from_part, from_part + 1.0 / kFineRounds), show))
      return std::nullopt;
  }
  return phi;
}

}  // namespace glisson::segmentation
