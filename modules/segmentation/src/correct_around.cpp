// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/correct_around.h"

#include <algorithm>
#include <cmath>

#include "bodies.h"
#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "intensity_ratio.h"
#include "level_set.h"
#include "painting.h"
#include "part.h"
#include "region_cut.h"
#include "same_click.h"

namespace glisson::segmentation {
namespace {

constexpr double kSpacing = 2.0;     // mm
constexpr double kMostReach = 60.0;  // mm from the click
constexpr double kRim = 12.0;        // mm around that, whose labels are evidence
constexpr double kLeastDepth = 6.0;  // mm: an error that can be seen and clicked is as deep
constexpr double kReach = 2.5;       // of the depth, beyond which labels stay
constexpr float kWeight = 0.1F;      // per mm, of evidence and odds; a border costs 0.1 to 1 per mm^2
constexpr double kGreyOfLiver = 110.0, kNoiseOfLiver = 8.0;  // HU, that an MRI's greys are carried to

enum class Holder { nobody, click, other };

/// Whose side a place is whatever the cut says: that of the nearest click, if it is near.
/// @param others clicks for the other side.
Holder holder_of(const Click& click, const Points& others, const Eigen::Vector3d& p) {
  double away = (p - click.p_in_ct.xyz).norm();
  Holder holder = Holder::click;
  for (Eigen::Index n = 0; n < others.rows(); ++n) {
    const double this_far = (p - others.row(n).transpose()).norm();
    if (this_far >= away) continue;
    away = this_far;
    holder = Holder::other;
  }
  return 1e3 * away <= kHeld ? holder : Holder::nobody;
}

/// The surroundings of a click.
struct Scene {
  VoxelBox box;     ///< of the image
  VolumeGrid part;  ///< the image's voxels in it
  Points others;    ///< clicks for the other side
  Field ct;
  Mask liver, own;                ///< own: what lies on the click's side of the border
  Mask fixed;                     ///< neither gained nor lost
  std::vector<float> from_click;  ///< mm
  Eigen::Vector3i click;
  double depth = 0.0, reach = 0.0;  ///< mm

  /// The mask, and one voxel around it.
  Mask with_rim(const Mask& mask) const { return dilated(mask, 1.1 * ct.spacing_mm.maxCoeff()); }
};

/// The greys of an MRI by two of the liver's figures, so that differences in HU mean the same.
void carry_to_ct(Field& field, const Mask& liver) {
  std::vector<float> greys;
  for (std::size_t i = 0; i < liver.voxels.size(); ++i)
    if (liver.voxels[i] != 0) greys.push_back(field.values[i]);
  const auto [middle, deviation] = robust_spread(std::move(greys));
  const double sigma = std::max(1e-3, deviation);
  for (float& v : field.values)
    v = static_cast<float>(kGreyOfLiver + kNoiseOfLiver / sigma * static_cast<double>(v - middle));
}

/// Calls visit(voxel, its offset) for each voxel of a grid.
template <class Visit>
void each_voxel(const Field& grid, const Visit& visit) {
  std::size_t at = 0;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i, ++at) visit(Eigen::Vector3i(i, j, k), at);
}

/// What is locked, and what lies beside the liver under a name of its own.
Mask fixed_of(const LabelMap& labels, const std::vector<Label>& locked, const Field& grid) {
  const auto is_fixed = [&](Label label) {
    const bool may_be_within = label == structure::kBackground || is_liver_tissue(label) ||
                               label == structure::kPortalVein || label == structure::kHepaticVeins;
    return !may_be_within || is_among(locked, label);
  };
  return sampled(labels.voxels.grid(), labels.voxels.mask(is_fixed), grid);
}

Scene scene_of(const Image& image, const LabelMap& all_labels, const Seeds& seeds, const Click& click,
               const std::vector<Label>& locked) {
  Scene scene;
  const Points place = click.p_in_ct.xyz.transpose();
  scene.box = box_around(image.grid, place, kMostReach + kRim);
  const Image part = part_of(image, scene.box);
  const LabelMap labels = part_of(all_labels, scene.box);
  const Seeds near = part_of(seeds, part.grid, {});
  scene.part = part.grid;
  scene.others = click.is_liver ? near.background : near.liver;
  scene.ct = resampled(part, {Eigen::Vector3i::Zero(), part.grid.size}, kSpacing);
  scene.liver = sampled(part.grid, inside_liver(labels), scene.ct);
  if (scene.liver.count() == 0) return scene;
  if (part.modality != Modality::ct) carry_to_ct(scene.ct, scene.liver);
  denoise(scene.ct);
  scene.own = click.is_liver ? scene.liver : complement(scene.liver);
  scene.click = voxels_of(part.grid, scene.ct, place).front();
  const float outside2 = squared_distance_mm2(scene.own)[scene.ct.offset(scene.click)];
  scene.depth = std::min(std::sqrt(static_cast<double>(outside2)), kMostReach) + kLeastDepth;
  scene.reach = std::min(kReach * scene.depth, kMostReach);
  scene.fixed = fixed_of(labels, locked, scene.ct);
  scene.from_click.resize(scene.own.voxels.size());
  each_voxel(scene.ct, [&](const Eigen::Vector3i& v, std::size_t at) {
    scene.from_click[at] =
        static_cast<float>((v - scene.click).cast<double>().cwiseProduct(scene.ct.spacing_mm).norm());
    const Eigen::Vector3d index = scene.ct.first_index + v.cast<double>().cwiseProduct(scene.ct.step);
    if (holder_of(click, scene.others, part.grid.p_in_ct(index).xyz) == Holder::other)
      scene.fixed.voxels[at] = 1;
  });
  return scene;
}

/// Likelihood ratio of intensities: those at the click and on its side of the border, to those on the other
/// side. The latter count the more the farther they lie from the click, since near it they are mostly wrong.
IntensityRatio evidence_of(const Scene& scene) {
  IntensityHistogram own, other;
  double owned = 0.0, clicked = 0.0;
  for (std::size_t i = 0; i < scene.ct.values.size(); ++i) {
    if (scene.own.voxels[i] != 0) owned += 1.0;
    if (scene.from_click[i] <= static_cast<float>(kHeld)) clicked += 1.0;
  }
  for (std::size_t i = 0; i < scene.ct.values.size(); ++i) {
    const float hu = scene.ct.values[i];
    // The click alone counts as much as all that lies on its side.
    if (scene.own.voxels[i] != 0) own.add(hu);
    if (scene.from_click[i] <= static_cast<float>(kHeld))
      for (int d = -10; d <= 10; ++d)
        own.add(hu + static_cast<float>(d), std::max(owned, 1.0) / (21.0 * clicked));
    const double far = std::min(1.0, static_cast<double>(scene.from_click[i]) / kMostReach);
    if (scene.own.voxels[i] == 0) other.add(hu, far * far);
  }
  return {own, other};
}

/// The voxels that change sides. Empty: cancelled.
Cancellable<Mask> changed_by(const Scene& scene, const RunContext& context) {
  const IntensityRatio evidence = evidence_of(scene);
  const auto depth = static_cast<float>(scene.depth), reach = static_cast<float>(scene.reach);
  Mask open = scene.ct.empty_mask();
  for (std::size_t i = 0; i < open.voxels.size(); ++i)
    open.voxels[i] = scene.own.voxels[i] == 0 && scene.fixed.voxels[i] == 0 && scene.from_click[i] < reach;
  const Mask beside = scene.with_rim(open);
  std::vector<float> reward(open.voxels.size(), 0.0F);
  for (std::size_t i = 0; i < open.voxels.size(); ++i) {
    if (scene.own.voxels[i] != 0 && beside.voxels[i] != 0) {
      // Deeper ones would be the same to the cut.
      open.voxels[i] = 1;
      reward[i] = kKnown;
    } else if (open.voxels[i] != 0) {
      const float odds = std::clamp(1.0F - scene.from_click[i] / depth, -1.0F, 1.0F);
      reward[i] = kWeight * (std::clamp(evidence(scene.ct.values[i]), -1.0F, 1.0F) + odds);
      if (scene.from_click[i] <= static_cast<float>(kHeld)) reward[i] = kKnown;
    }
  }
  const auto region = best_region(scene.ct, open, reward, context);
  if (!region) return std::nullopt;
  Mask changed = *region;
  for (std::size_t i = 0; i < changed.voxels.size(); ++i)
    if (scene.own.voxels[i] != 0) changed.voxels[i] = 0;
  std::vector<long> sizes;
  const std::vector<int> pieces = connected_components(changed, sizes);
  const int clicked = pieces[scene.ct.offset(scene.click)];
  for (std::size_t i = 0; i < changed.voxels.size(); ++i)
    changed.voxels[i] = clicked != 0 && pieces[i] == clicked ? 1 : 0;
  return changed;
}

/// What the change encloses of the other side goes with it, unless a click lies in it.
void take_enclosed(const Scene& scene, Mask& changed) {
  Mask all = scene.own;
  unite(all, changed);
  std::vector<long> sizes;
  const std::vector<int> pieces = connected_components(complement(all), sizes);
  std::vector<std::uint8_t> stays(sizes.size() + 1, 0), touches(sizes.size() + 1, 0);
  for (const Eigen::Vector3i& v : voxels_of(scene.part, scene.ct, scene.others))
    stays[static_cast<std::size_t>(pieces[scene.ct.offset(v)])] = 1;
  const Mask near = scene.with_rim(changed);
  each_voxel(scene.ct, [&](const Eigen::Vector3i& v, std::size_t at) {
    const auto piece = static_cast<std::size_t>(pieces[at]);
    const bool at_edge = (v.array() == 0).any() || (v.array() == scene.ct.size.array() - 1).any();
    if (at_edge || piece == 1 || scene.fixed.voxels[at] != 0) stays[piece] = 1;
    if (near.voxels[at] != 0) touches[piece] = 1;
  });
  for (std::size_t i = 0; i < changed.voxels.size(); ++i) {
    const auto piece = static_cast<std::size_t>(pieces[i]);
    if (piece != 0 && stays[piece] == 0 && touches[piece] != 0) changed.voxels[i] = 1;
  }
}

/// Whether the change hangs together with what lies on its side already.
bool is_attached(const Scene& scene, const Mask& changed) {
  const Mask near = scene.with_rim(changed);
  for (std::size_t i = 0; i < near.voxels.size(); ++i)
    if (near.voxels[i] != 0 && scene.own.voxels[i] != 0) return true;
  return false;
}

/// Puts the change into the labels.
void paint(const Scene& scene, const Mask& changed, const Click& click, const std::vector<Label>& locked,
           CorrectedAround& result) {
  LabelVolume& labels = result.labels.voxels;
  Mask side = scene.own;
  unite(side, changed);
  const Field phi = smooth_boundary(side, scene.ct);
  const VoxelBox around = image_box(scene.part, scene.ct, changed, kSpacing);
  const std::vector<float> values = on_image(phi, around);
  const Mask near = scene.with_rim(changed);
  const Label to = click.is_liver ? structure::kParenchyma : structure::kBackground;
  std::size_t at = 0;
  for (int k = around.low.z(); k < around.high.z(); ++k)
    for (int j = around.low.y(); j < around.high.y(); ++j)
      for (int i = around.low.x(); i < around.high.x(); ++i, ++at) {
        const Eigen::Vector3i v = scene.ct.voxel_of(Eigen::Vector3d(i, j, k));
        if (!scene.ct.contains(v) || near.voxels[scene.ct.offset(v)] == 0) continue;
        const Eigen::Vector3i place = scene.box.low + Eigen::Vector3i(i, j, k);
        const Eigen::Vector3d p = labels.grid().p_in_ct(place.cast<double>()).xyz;
        const Holder holder = holder_of(click, scene.others, p);
        if (holder == Holder::other || (holder == Holder::nobody && !(values[at] < 0.0F))) continue;
        const Label label = labels.at(place);
        const bool changes = click.is_liver ? label == structure::kBackground : is_liver_tissue(label);
        if (!changes || is_among(locked, label)) continue;
        labels.set(place, to);
        ++result.voxels_changed;
        result.reach_mm = std::max(result.reach_mm, 1e3 * (p - click.p_in_ct.xyz).norm());
      }
}

/// The click's number in its list, from 1.
std::string number_of(const Click& click, const Seeds& seeds) {
  return std::to_string(
      click_number(click.is_liver ? seeds.liver : seeds.background, click.p_in_ct.xyz.transpose()));
}

/// What keeps a click from binding: another structure lies there, or what is locked.
std::optional<std::string> taken_note(const LabelMap& labels, const Click& click, const Seeds& seeds,
                                      const std::vector<Label>& locked) {
  const VolumeGrid& grid = labels.voxels.grid();
  const Eigen::Vector3i voxel = grid.index_of(click.p_in_ct)
                                    .array()
                                    .round()
                                    .matrix()
                                    .cast<int>()
                                    .cwiseMax(0)
                                    .cwiseMin(grid.size - Eigen::Vector3i::Ones());
  const Label label = labels.voxels.at(voxel);
  const bool is_taken =
      label != structure::kBackground &&
      (click.is_liver ? !is_in_liver(label) : is_in_liver(label) && !is_liver_tissue(label));
  if (!is_taken && (click.is_liver || !is_among(locked, label))) return {};
  return std::string(click.is_liver ? "seed.liver_taken " : "seed.not_liver_taken ") +
         number_of(click, seeds) + " " + structure_name(label);
}

void check(const Image& image, const LabelMap& labels, const Click& click, const std::vector<Label>& locked) {
  if (image.empty()) throw InputError("image", "", "is empty", "Import a CT or MRI first");
  require_same_grid(labels.voxels.grid(), image.grid, "labels that are corrected");
  if (!holds(image.grid, click.p_in_ct.xyz))
    throw InputError("seeds", click.is_liver ? "liver" : "background", "lies outside the image",
                     "Check that the seeds belong to this image and are in mm (LPS)");
  if (is_among(locked, structure::kParenchyma))
    throw InputError("labels", "liver", "is locked", "Unlock it, or click another structure");
}

}  // namespace

std::vector<Click> clicks_added(const Seeds& before, const Seeds& after) {
  std::vector<Click> added;
  const auto add = [&](const Points& old, const Points& now, bool is_liver) {
    for (Eigen::Index n = 0; n < now.rows(); ++n)
      if (!holds_click(old, now.row(n)))
        added.push_back({Point<CtFrame>(Eigen::Vector3d(now.row(n).transpose())), is_liver});
  };
  add(before.liver, after.liver, true);
  add(before.background, after.background, false);
  return added;
}

Cancellable<CorrectedAround> correct_around(const Image& image, const LabelMap& labels, const Seeds& seeds,
                                            const Click& click, const std::vector<Label>& locked,
                                            const RunContext& context) {
  check(image, labels, click, locked);
  context.progress(0.0, "segmentation.around");
  CorrectedAround result{labels, 0.0, 0, {}};
  if (auto note = taken_note(labels, click, seeds, locked)) {
    result.notes.push_back(std::move(*note));
    return result;
  }
  const Scene scene = scene_of(image, labels, seeds, click, locked);
  const std::string apart = "seed.liver_apart " + number_of(click, seeds);
  if (scene.liver.count() == 0) {
    if (click.is_liver) result.notes.push_back(apart);
    return result;
  }
  if (context.cancelled()) return std::nullopt;
  context.progress(0.3, "segmentation.around");
  auto changed = changed_by(scene, context.part(0.3, 0.9));
  if (!changed) return std::nullopt;
  if (click.is_liver && changed->count() > 0 && !is_attached(scene, *changed)) {
    result.notes.push_back(apart);
    return result;
  }
  if (changed->count() > 0) take_enclosed(scene, *changed);
  // The CT's voxels at the click must change even if the coarse voxel around it is on the right side already.
  changed->voxels[scene.ct.offset(scene.click)] = 1;
  paint(scene, *changed, click, locked, result);
  if (click.is_liver && result.voxels_changed > 0) name_structure(structure::kParenchyma, result.labels);
  context.progress(1.0, "segmentation.around");
  return result;
}

}  // namespace glisson::segmentation
