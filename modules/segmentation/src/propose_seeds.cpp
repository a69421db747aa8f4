// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/propose_seeds.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "field.h"
#include "glisson/core/error.h"
#include "parting.h"
#include "tissue.h"

namespace glisson::segmentation {
namespace {

constexpr double kSpacing = 3.0, kSmoothing = 2.0;     // mm
constexpr double kDarkest = 20.0, kBrightest = 220.0;  // HU of livers, unenhanced to late portal
constexpr double kStep = 10.0, kWindow = 22.0;         // HU
constexpr double kCore = 12.0;                         // mm: deeper in a body than in most muscles
constexpr double kLeastCoreMl = 80.0;                  // a ball of 8 cm has that much
constexpr int kSeeds = 5;
constexpr float kAir = -200.0F;  // HU
constexpr double kRight = 0.04;  // metres from the patient's middle: no heart's right half reaches so far
constexpr double kUnlike = 3.0;  // sigmas

template <class Wanted>
Mask where(const Field& ct, const Wanted& wanted) {
  Mask mask = ct.empty_mask();
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) mask.voxels[i] = wanted(i) ? 1 : 0;
  return mask;
}

/// The CT, coarse, with where its voxels are in the patient.
struct Scene {
  Field ct;
  const VolumeGrid& grid;  ///< of the image
  double middle_x = 0.0;   ///< of the patient; x grows to the left

  /// So far on the right that no heart, stomach or spleen lies there.
  bool is_right(std::size_t at) const { return place(at).x() < middle_x - kRight; }

  Eigen::Vector3d place(std::size_t at) const {
    return grid.p_in_ct(ct.first_index + ct.voxel_at(at).cast<double>().cwiseProduct(ct.step)).xyz;
  }
  double voxel_ml() const { return 1e-3 * ct.spacing_mm.prod(); }
  Eigen::Vector3d middle(const Mask& mask) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < mask.voxels.size(); ++i)
      if (mask.voxels[i] != 0) sum += place(i);
    return sum / static_cast<double>(std::max<long>(mask.count(), 1));
  }
};

Mask like(const Field& ct, double middle, double width) {
  return closed(where(ct, [&](std::size_t i) { return std::abs(ct.values[i] - middle) < width; }),
                kVesselWidth);
}

/// A compact body of even tissue: what of it lies deeper than kCore.
struct Core {
  Mask mask;
  double right_ml = 0.0;  ///< of it, where right organs are
};

/// The one of them that has most on the right.
Core core_of(const Scene& scene, const Mask& tissue) {
  const std::vector<float> depth2 = squared_depth_mm2(tissue);
  std::vector<long> sizes;
  const std::vector<int> component =
      connected_components(where(scene.ct, [&](std::size_t i) { return depth2[i] > kCore * kCore; }), sizes);
  std::vector<long> right(sizes.size() + 1, 0);
  for (std::size_t i = 0; i < component.size(); ++i)
    if (component[i] != 0 && scene.is_right(i)) ++right[static_cast<std::size_t>(component[i])];
  const auto most = std::max_element(right.begin(), right.end());
  const auto chosen = static_cast<int>(most - right.begin());
  return {where(scene.ct, [&](std::size_t i) { return chosen != 0 && component[i] == chosen; }),
          static_cast<double>(*most) * scene.voxel_ml()};
}

/// Places far from each other: the deepest first, then always the one farthest from those that are chosen,
/// what is deep counting for more.
Points spread(const Scene& scene, const Mask& allowed, const std::vector<float>& depth2, int count) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < allowed.voxels.size(); ++i)
    if (allowed.voxels[i] != 0) places.push_back(i);
  std::vector<Eigen::Vector3d> chosen;
  std::vector<double> away(places.size(), 1.0);
  while (static_cast<int>(chosen.size()) < count && !places.empty()) {
    std::size_t best = 0;
    double most = -1.0;
    for (std::size_t n = 0; n < places.size(); ++n) {
      const double worth = away[n] * std::sqrt(static_cast<double>(depth2[places[n]]));
      if (worth > most) most = worth, best = n;
    }
    if (most <= 0.0) break;
    const Eigen::Vector3d p = scene.place(places[best]);
    for (std::size_t n = 0; n < places.size(); ++n) {
      const double distance = (scene.place(places[n]) - p).norm();
      away[n] = chosen.empty() ? distance : std::min(away[n], distance);
    }
    chosen.push_back(p);
  }
  Points points(static_cast<Eigen::Index>(chosen.size()), 3);
  for (std::size_t n = 0; n < chosen.size(); ++n)
    points.row(static_cast<Eigen::Index>(n)) = chosen[n].transpose();
  return points;
}

/// The tissue whose compact body has most on the right.
Cancellable<Core> find_liver_core(const Scene& scene, const RunContext& context) {
  Core best;
  for (double hounsfield = kDarkest; hounsfield <= kBrightest; hounsfield += kStep) {
    if (context.cancelled()) return std::nullopt;
    context.progress(0.8 * (hounsfield - kDarkest) / (kBrightest - kDarkest), "segmentation.propose");
    Core core = core_of(scene, like(scene.ct, hounsfield, kWindow));
    if (core.right_ml > best.right_ml) best = std::move(core);
  }
  return best;
}

InputError no_liver() {
  return {"image", "", "shows nothing as large, compact and even as a liver", "Click the liver yourself"};
}

}  // namespace

Cancellable<PointsIn<CtFrame>> propose_liver_seeds(const Image& image, const RunContext& context) {
  require_ct(image);
  Scene scene{resampled(image, {Eigen::Vector3i::Zero(), image.grid.size}, kSpacing), image.grid, 0.0};
  smooth(scene.ct, kSmoothing);
  const Field& ct = scene.ct;
  scene.middle_x =
      scene.middle(largest_component(where(ct, [&](std::size_t i) { return ct.values[i] > kAir; }))).x();
  const auto core = find_liver_core(scene, context);
  if (!core) return std::nullopt;
  if (core->right_ml < kLeastCoreMl) throw no_liver();
  const Tissue liver = tissue_in(ct, core->mask);
  const Mask alike = like(ct, liver.mean, kUnlike * liver.sigma);
  const std::vector<float> depth2 = squared_depth_mm2(alike);
  // Other organs that look alike are parted from it at their necks, as from a click in its deepest place on
  // the right.
  std::optional<std::size_t> deepest;
  for (std::size_t i = 0; i < depth2.size(); ++i)
    if (core->mask.voxels[i] != 0 && scene.is_right(i) && (!deepest || depth2[i] > depth2[*deepest]))
      deepest = i;
  require(deepest.has_value(), "a body with so much on the right has voxels there");
  const auto sides =
      part_at_necks(ct, alike, {{scene.ct.voxel_at(*deepest)}, {}}, context.quiet(), kCertainFace);
  if (!sides) return std::nullopt;
  const Mask places = where(ct, [&](std::size_t i) {
    return sides->own.voxels[i] != 0 && depth2[i] > kCore * kCore && scene.is_right(i) &&
           std::abs(ct.values[i] - liver.mean) < liver.sigma;
  });
  PointsIn<CtFrame> seeds(spread(scene, places, depth2, kSeeds));
  if (seeds.rows() == 0) throw no_liver();
  return seeds;
}

}  // namespace glisson::segmentation
