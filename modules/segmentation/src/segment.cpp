// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/segment.h"

#include <algorithm>
#include <cmath>

#include "bodies.h"
#include "glisson/core/error.h"
#include "glisson/volume/io.h"
#include "glisson/volume/plausibility.h"
#include "live_view.h"
#include "metal.h"
#include "mr_scale.h"
#include "painting.h"
#include "part.h"
#include "remarks.h"
#include "vessels.h"

namespace glisson::segmentation {
namespace {

constexpr double kVesselSpacing = 1.0;  // mm
constexpr double kAroundTrees = 15.0;   // mm that trees are looked for in around the liver and their clicks
constexpr int kLeastRegion = 8;         // voxels a side

void check_points(const Image& image, const Points& points, const std::string& name) {
  for (Eigen::Index n = 0; n < points.rows(); ++n) {
    if (!holds(image.grid, points.row(n).transpose()))
      throw InputError("seeds", name + " " + std::to_string(n + 1), "lies outside the image",
                       "Check that the seeds belong to this image and are in mm (LPS)");
  }
}

void check_input(const Image& image, const Seeds& seeds) {
  if (image.empty()) throw InputError("image", "", "is empty", "Import a CT or MRI first");
  check_points(image, seeds.liver, "liver");
  check_points(image, seeds.portal_vein, "portal_vein");
  check_points(image, seeds.hepatic_veins, "hepatic_veins");
  check_points(image, seeds.vena_cava, "vena_cava");
  check_points(image, seeds.gallbladder, "gallbladder");
  check_points(image, seeds.background, "background");
  for (std::size_t n = 0; n < seeds.lesions.size(); ++n)
    check_points(image, seeds.lesions[n], "lesions " + std::to_string(n + 1));
  check_diameters("seeds", seeds);
  if (seeds.lesions.size() > structure::kLastLesion - structure::kFirstLesion + 1U)
    throw InputError("seeds", "lesions", "are more than there are labels for", "Click the largest ones");
}

/// What is locked is not found anew; with the parenchyma locked, nor is what borders on it from within.
Structures unlocked(Structures asked, const std::vector<Label>& locked) {
  for (const Label label : locked) {
    const bool parenchyma = label == structure::kParenchyma;
    asked.liver = asked.liver && !parenchyma;
    asked.lesions = asked.lesions && !parenchyma;
    asked.portal_vein = asked.portal_vein && !parenchyma && label != structure::kPortalVein;
    asked.hepatic_veins = asked.hepatic_veins && !parenchyma && label != structure::kHepaticVeins;
    asked.vena_cava = asked.vena_cava && label != structure::kVenaCava;
    asked.gallbladder = asked.gallbladder && label != structure::kGallbladder;
  }
  return asked;
}
Seeds unlocked(Seeds seeds, const std::vector<Label>& locked) {
  for (const Label label : locked) {
    const auto lesion = static_cast<std::size_t>(label - structure::kFirstLesion);
    if (is_lesion(label) && lesion < seeds.lesions.size()) seeds.lesions[lesion] = PointsIn<CtFrame>(0, 3);
  }
  return seeds;
}

/// What has seeds, and was asked for.
Structures found_anew(const Structures& asked, const Seeds& seeds) {
  Structures anew = asked;
  anew.portal_vein = asked.portal_vein && seeds.portal_vein.rows() > 0;
  anew.hepatic_veins = asked.hepatic_veins && seeds.hepatic_veins.rows() > 0;
  anew.vena_cava = asked.vena_cava && seeds.vena_cava.rows() > 0;
  anew.gallbladder = asked.gallbladder && seeds.gallbladder.rows() > 0;
  anew.lesions = asked.lesions && std::any_of(seeds.lesions.begin(), seeds.lesions.end(),
                                              [](const Points& lesion) { return lesion.rows() > 0; });
  return anew;
}

/// What nothing was found of stays as it was: structures, and single lesions.
Structures where_found(Structures anew, const Bodies& bodies, const Vessels& trees) {
  anew.portal_vein = anew.portal_vein && trees.portal.count() > 0;
  anew.hepatic_veins = anew.hepatic_veins && trees.hepatic.count() > 0;
  anew.vena_cava = anew.vena_cava && bodies.cava.count() > 0;
  anew.gallbladder = anew.gallbladder && bodies.gallbladder.count() > 0;
  return anew;
}
Seeds where_found(Seeds seeds, const Bodies& bodies) {
  for (std::size_t n = 0; n < bodies.lesions.size(); ++n)
    if (!is_found(bodies.lesions[n])) seeds.lesions[n] = PointsIn<CtFrame>(0, 3);
  return seeds;
}

/// The kept labels, without what is found anew. A kept liver is whole again where vessels or lesions were.
Painting prepared(const Image& image, const Seeds& seeds, const Structures& anew, const Kept* kept,
                  bool parenchyma_held) {
  const auto count = static_cast<std::size_t>(image.grid.voxel_count());
  Painting painting{image.grid, std::vector<Label>(count, 0), std::vector<std::uint8_t>(count, 0)};
  if (kept == nullptr) return painting;
  painting.labels = kept->labels.voxels.dense();
  for (std::size_t i = 0; i < count; ++i) {
    Label& label = painting.labels[i];
    // A locked liver does not grow either.
    const bool is_liver = !anew.liver && kept->liver[i] != 0 && !parenchyma_held;
    if (label != 0 && is_anew(anew, seeds, label)) label = is_liver ? structure::kParenchyma : Label{0};
    painting.held[i] = label != 0 && (parenchyma_held || label != structure::kParenchyma);
  }
  return painting;
}

/// Grows the box to what lies around clicks that are not far from it.
void add_clicks(const VolumeGrid& grid, const Points& clicks, VoxelBox& box) {
  const Eigen::Vector3d far = kFarthestClick * grid.spacing_mm.cwiseInverse();
  const VoxelBox before = box;
  for (Eigen::Index n = 0; n < clicks.rows(); ++n) {
    const VoxelBox around = box_around(grid, Points(clicks.row(n)), kAroundTrees);
    if ((around.high.cast<double>().array() < before.low.cast<double>().array() - far.array()).any() ||
        (around.low.cast<double>().array() > before.high.cast<double>().array() + far.array()).any())
      continue;
    box = {box.low.cwiseMin(around.low), box.high.cwiseMax(around.high)};
  }
}

/// Both trees, on voxels of 1 mm around the liver.
struct FoundVessels {
  VoxelBox box;
  Field grid;
  Vessels trees;
};

Cancellable<FoundVessels> find_trees(const Image& image, const Seeds& seeds, const Bodies& bodies,
                                     const Structures& anew, const Kept* kept, bool from_cava,
                                     const RunContext& context) {
  FoundVessels found;
  if (!anew.portal_vein && !anew.hepatic_veins) return found;
  Mask everything = bodies.liver;
  unite(everything, bodies.cava);
  unite(everything, bodies.gallbladder);
  found.box = image_box(image.grid, bodies.grid, everything, kAroundTrees);
  if (anew.portal_vein) add_clicks(image.grid, seeds.portal_vein, found.box);
  if (anew.hepatic_veins) add_clicks(image.grid, seeds.hepatic_veins, found.box);
  found.grid = resampled(image, found.box, kVesselSpacing);
  smooth(found.grid, 0.7);
  if (context.cancelled()) return std::nullopt;
  const Field& fine = found.grid;
  VesselSeeds roots;
  roots.from_cava = from_cava;
  if (anew.portal_vein) roots.portal = voxels_of(image.grid, fine, seeds.portal_vein);
  if (anew.hepatic_veins) roots.hepatic = voxels_of(image.grid, fine, seeds.hepatic_veins);
  Mask barred = fine.empty_mask();
  if (kept != nullptr)
    barred = sampled(image.grid, kept->labels.voxels.mask([&](Label label) {
      return label != 0 && label != structure::kParenchyma && label != structure::kVenaCava &&
             !is_anew(anew, seeds, label);
    }),
                     fine);
  auto trees = find_vessels(fine, transferred(bodies.liver_phi, fine),
                            transferred(smooth_boundary(bodies.cava, bodies.grid), fine), barred,
                            bodies.parenchyma, roots, context);
  if (!trees) return std::nullopt;
  found.trees = std::move(*trees);
  return found;
}

/// The largest first, so that a small one beside it is seen. A vessel that runs by or through one that does
/// not enhance stays.
void paint_lesions(const std::vector<GrownLesion>& lesions, Painting& painting) {
  std::vector<std::pair<long, std::size_t>> order;
  for (std::size_t n = 0; n < lesions.size(); ++n)
    if (is_found(lesions[n])) order.emplace_back(-negative_of(lesions[n].phi).count(), n);
  std::sort(order.begin(), order.end());
  const std::vector<std::uint8_t> held = painting.held;
  std::vector<std::uint8_t> held_with_vessels = held;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (painting.labels[i] == structure::kPortalVein || painting.labels[i] == structure::kHepaticVeins)
      held_with_vessels[i] = 1;
  for (const auto& [size, n] : order) {
    const Field& phi = lesions[n].phi;
    painting.held = lesions[n].bright ? held : held_with_vessels;
    painting.paint(phi, image_box(painting.grid, phi, negative_of(phi), 4.0),
                   static_cast<Label>(structure::kFirstLesion + n));
  }
  painting.held = held;
}

/// What is painted later covers what was painted before.
void paint_all(const Bodies& bodies, const FoundVessels& vessels, const Structures& anew,
               Painting& painting) {
  const auto body = [&](const Mask& mask, Label label) {
    if (mask.count() > 0)
      painting.paint(smooth_boundary(mask, bodies.grid), image_box(painting.grid, bodies.grid, mask, 4.0),
                     label);
  };
  if (anew.liver)
    painting.paint(bodies.liver_phi, image_box(painting.grid, bodies.grid, bodies.liver, 8.0),
                   structure::kParenchyma);
  // Not smoothed: a branch of one voxel would vanish.
  if (anew.hepatic_veins)
    painting.paint(signed_distance(vessels.trees.hepatic, vessels.grid), vessels.box,
                   structure::kHepaticVeins);
  if (anew.portal_vein)
    painting.paint(signed_distance(vessels.trees.portal, vessels.grid), vessels.box, structure::kPortalVein);
  if (anew.vena_cava) body(bodies.cava, structure::kVenaCava);
  if (anew.gallbladder) body(bodies.gallbladder, structure::kGallbladder);
  paint_lesions(bodies.lesions, painting);
}

/// The painting put in its place in the whole image; bricks in which nothing changed are shared with `kept`.
LabelMap placed(const Painting& painting, const VoxelBox& box,
                const std::optional<Eigen::AlignedBox3d>& region, const VolumeGrid& grid,
                const LabelMap* kept) {
  LabelMap result;
  if (kept != nullptr) result = *kept;
  if (!region && kept == nullptr) {
    result.voxels = LabelVolume(grid, painting.labels);
  } else {
    if (kept == nullptr) result.voxels = LabelVolume(grid);
    std::size_t at = 0;
    for (int k = box.low.z(); k < box.high.z(); ++k)
      for (int j = box.low.y(); j < box.high.y(); ++j)
        for (int i = box.low.x(); i < box.high.x(); ++i, ++at)
          if (is_in(region, grid, {i, j, k})) result.voxels.set({i, j, k}, painting.labels[at]);
  }
  const std::vector<LabelInfo> known = std::move(result.infos);
  result.infos.clear();
  const std::vector<long> counts = result.voxels.histogram();
  for (std::size_t label = 1; label < counts.size(); ++label) {
    if (counts[label] == 0) continue;
    const auto code = static_cast<Label>(label);
    const auto info =
        std::find_if(known.begin(), known.end(), [&](const LabelInfo& i) { return i.code == code; });
    result.infos.push_back(info != known.end() ? *info : structure_info(code));
  }
  return result;
}

}  // namespace

void SegmentationOptions::validate() const {
  if (!(working_spacing_mm >= 0.3 && working_spacing_mm <= 5.0))
    throw InputError("options", "working_spacing_mm", "is " + std::to_string(working_spacing_mm),
                     "Choose 0.3 to 5 mm");
}

bool is_found_anew(Label label, const SegmentationOptions& options, const VolumeGrid& grid,
                   const Seeds& all_seeds) {
  const Seeds seeds = part_of(unlocked(all_seeds, options.locked), grid, options.region);
  return is_anew(found_anew(unlocked(options.structures, options.locked), seeds), seeds, label);
}

namespace {

/// Why a structure that was asked for is not looked for. @param without_locks what would be, were nothing
/// locked.
InputError not_looked_for(const char* code, bool Structures::*structure, const SegmentationOptions& options,
                          const Structures& without_locks) {
  if (!(without_locks.*structure))
    return {"seeds", code, options.region ? "has no point in the region" : "has no point",
            "Click it first, or find something else anew"};
  const bool is_within = structure != &Structures::vena_cava && structure != &Structures::gallbladder;
  const bool by_liver = is_within && is_among(options.locked, structure::kParenchyma);
  return {"labels", by_liver ? "liver" : code, "is locked", "Unlock it, or find something else anew"};
}

}  // namespace

void require_something_to_find(const SegmentationOptions& options, const VolumeGrid& grid,
                               const Seeds& seeds) {
  const Structures without_locks = found_anew(options.structures, part_of(seeds, grid, options.region));
  const Structures anew = found_anew(unlocked(options.structures, options.locked),
                                     part_of(unlocked(seeds, options.locked), grid, options.region));
  for (const auto& [code, structure] : kStructureCodes)
    if (anew.*structure) return;
  for (const auto& [code, structure] : kStructureCodes)
    if (options.structures.*structure) throw not_looked_for(code, structure, options, without_locks);
}

std::optional<Hindrance> hindrance(const SegmentationOptions& options, const VolumeGrid& grid,
                                   const Seeds& seeds, bool keeps_labels) {
  if (options.region && (box_of(grid, options.region).size().array() < kLeastRegion).any())
    return Hindrance::small_region;
  if (!unlocked(options.structures, options.locked).liver)
    return keeps_labels ? std::nullopt : std::optional(Hindrance::no_kept_liver);
  if (part_of(seeds, grid, options.region).liver.rows() > 0) return std::nullopt;
  return seeds.liver.rows() > 0 ? Hindrance::no_liver_seed_in_region : Hindrance::no_liver_seed;
}

namespace {

InputError error_of(Hindrance which) {
  const char* remedy = "Click at least one point inside the liver";
  switch (which) {
    case Hindrance::small_region:
      return {"options", "region", "holds too little of the image", "Draw the region around the liver"};
    case Hindrance::no_liver_seed:
      return {"seeds", "liver", "has no point", remedy};
    case Hindrance::no_liver_seed_in_region:
      return {"seeds", "liver", "has no point in the region", remedy};
    case Hindrance::no_kept_liver:
      return {"labels", "liver", "is not there, and was not to be segmented",
              "Segment the liver too, or paint it first"};
  }
  throw PreconditionError("a hindrance has a sentence");
}

/// segment() on the scale of a CT. @pre the input is checked, and nothing hinders.
Cancellable<Segmented> segment_ct(const Image& whole, const Seeds& all_seeds,
                                  const SegmentationOptions& options, const RunContext& context,
                                  const LabelMap* all_kept, const ShowLiver& show) {
  const VoxelBox box = box_of(whole.grid, options.region);
  const Image image = part_of(whole, box);
  const Seeds seeds = part_of(unlocked(all_seeds, options.locked), image.grid, options.region);
  const Structures anew = found_anew(unlocked(options.structures, options.locked), seeds);
  std::optional<Kept> kept_part;
  if (all_kept != nullptr) {
    kept_part = Kept{part_of(*all_kept, box), {}};
    if (!anew.liver) kept_part->liver = inside_liver(kept_part->labels);
  }
  const Kept* kept = kept_part ? &*kept_part : nullptr;

  LiveView view(whole.grid, box, show);
  ShowContour show_contour;
  if (show) show_contour = [&](const Field& phi) { view.update(phi); };
  const auto bodies =
      find_bodies(image, seeds, options.working_spacing_mm, anew, kept, context.part(0.0, 0.6), show_contour);
  if (!bodies) return std::nullopt;
  if (bodies->liver.count() == 0)
    throw InputError("seeds", "liver", "grow to nothing: the clicks do not lie in liver tissue",
                     "Click inside the parenchyma, away from vessels and lesions");
  if (anew.liver) view.finish(bodies->liver_phi);
  const auto vessels =
      find_trees(image, seeds, *bodies, anew, kept, options.veins_from_cava, context.part(0.6, 0.95));
  if (!vessels) return std::nullopt;
  context.progress(0.95, "segmentation.finish");

  const bool parenchyma_held =
      std::find(options.locked.begin(), options.locked.end(), structure::kParenchyma) != options.locked.end();
  const Structures found = where_found(anew, *bodies, vessels->trees);
  Painting painting = prepared(image, where_found(seeds, *bodies), found, kept, parenchyma_held);
  paint_all(*bodies, *vessels, found, painting);
  Segmented result;
  result.labels = placed(painting, box, options.region, whole.grid, all_kept);
  result.report =
      report_on(whole, result.labels,
                {image, seeds, all_seeds, anew, found, *bodies, vessels->trees, painting, options.region});
  context.progress(1.0, "segmentation.finish");
  return result;
}

}  // namespace

Cancellable<Segmented> segment(const Image& image, const Seeds& seeds, const SegmentationOptions& options,
                               const RunContext& context, const LabelMap* kept, const ShowLiver& show) {
  options.validate();
  check_input(image, seeds);
  if (kept != nullptr) require_same_grid(kept->voxels.grid(), image.grid, "labels that are kept");
  if (const auto first = hindrance(options, image.grid, seeds, kept != nullptr)) throw error_of(*first);
  const double scaled = image.modality == Modality::ct ? 0.0 : 0.15;
  const auto on_scale = on_ct_scale(image, seeds, kept, context.part(0.0, scaled));
  if (!on_scale) return std::nullopt;
  auto result = segment_ct(*on_scale, seeds, options, context.part(scaled, 1.0), kept, show);
  if (!result) return std::nullopt;
  std::vector<std::string>& notes = result->report.notes;
  if (auto note = metal_note(image, result->labels.voxels)) notes.insert(notes.begin(), std::move(*note));
  // Before all others: what is wrong with the liver follows from it.
  const std::vector<std::string> scale = scale_doubts(image);
  notes.insert(notes.begin(), scale.begin(), scale.end());
  return result;
}

double dice(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  require(a.size() == b.size(), "masks that are compared have one size");
  long in_a = 0, in_b = 0, in_both = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    in_a += a[i] != 0;
    in_b += b[i] != 0;
    in_both += a[i] != 0 && b[i] != 0;
  }
  return in_a + in_b == 0 ? 1.0 : 2.0 * static_cast<double>(in_both) / static_cast<double>(in_a + in_b);
}

}  // namespace glisson::segmentation
