// SPDX-License-Identifier: GPL-3.0-or-later
#include "bodies.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bites.h"
#include "dark_bodies.h"
#include "enclosed.h"
#include "fronts.h"
#include "glisson/core/error.h"
#include "glisson/core/share_out.h"
#include "glisson/volume/axes.h"
#include "lesions.h"
#include "level_set.h"
#include "organs.h"
#include "painting.h"
#include "part.h"

namespace glisson::segmentation {
namespace {

constexpr double kCoarse = 2.0;        // mm: where the contour finds its way; finer is for its last moves
constexpr double kParting = 1.5;       // mm: voxels on which organs are parted
constexpr double kLiverReach = 250.0;  // mm: no liver is wider, and a click may lie at its end
constexpr double kFineBlur = 0.8;      // mm: fine voxels carry more noise than the diffusion tells from edges
constexpr double kDarkClick = 3.0;     // mm around a click on the liver that say what it lies in
constexpr double kDarkSigmas = 1.5;    // below the liver
constexpr double kLesionVoxel = 1.5, kLesionRim = 4.0;  // mm
constexpr double kMostVoxels = 50e6;                    // of the fine contour: about 3 GB
/// HU, from a very fatty liver to far above any enhancement: outside it the clicks, or the units, are wrong.
constexpr double kLeastLiver = -10.0, kMostLiver = 250.0;

/// The mask's boundary where the contour's sign differs from it; elsewhere the contour's own.
void correct(Field& phi, const Mask& mask) {
  const Field distance = signed_distance(mask, phi);
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    if ((phi.values[i] < 0.0F) != (mask.voxels[i] != 0)) phi.values[i] = distance.values[i];
}

/// One piece without holes, tumours included; thin wedges between them and the contour closed.
void clean_up(Bodies& bodies, const Mask& tumours) {
  Mask liver = negative_of(bodies.liver_phi);
  unite(liver, tumours);
  liver = holes_filled(largest_component(opened(liver, 2.0)));
  if (tumours.count() > 0) {
    const Mask near = dilated(tumours, 8.0), bridged = closed(liver, 6.0);
    for (std::size_t i = 0; i < liver.voxels.size(); ++i)
      if (near.voxels[i] != 0 && bridged.voxels[i] != 0) liver.voxels[i] = 1;
  }
  for (std::size_t i = 0; i < liver.voxels.size(); ++i)
    if (bodies.cava.voxels[i] != 0 || bodies.gallbladder.voxels[i] != 0) liver.voxels[i] = 0;
  bodies.liver = holes_filled(largest_component(liver));
  correct(bodies.liver_phi, bodies.liver);
}

Tissue tissue_at_clicks(const Field& ct, const std::vector<Eigen::Vector3i>& clicks) {
  const Tissue liver = tissue_around(ct, clicks, 6.0, 3.0, 15.0);
  if (liver.mean < kLeastLiver || liver.mean > kMostLiver)
    throw InputError("seeds", "liver",
                     "lies in tissue of " + std::to_string(std::lround(liver.mean)) +
                         " HU, which no liver has in the portal venous phase",
                     "Click inside the parenchyma of a CT in Hounsfield units");
  return liver;
}

Mask kept_mask(const LabelMap& kept, const Field& grid, const std::function<bool(Label)>& wanted) {
  return sampled(kept.voxels.grid(), kept.voxels.mask(wanted), grid);
}

/// The liver of the kept labels.
void take_liver(const Kept& kept, const Field& ct, Bodies& bodies) {
  bodies.liver = sampled(kept.labels.voxels.grid(), kept.liver, ct);
  const Mask parenchyma =
      kept_mask(kept.labels, ct, [](Label label) { return label == structure::kParenchyma; });
  if (parenchyma.count() == 0)
    throw InputError("labels", "liver", "is not there, and was not to be segmented",
                     "Segment the liver too, or paint it first");
  bodies.liver_phi = signed_distance(bodies.liver, ct);
  bodies.parenchyma = tissue_in(ct, parenchyma);
}

/// How far places lie outside of a contour, as far as kHeld reaches: on fine voxels its band is narrower.
Field distances_of(const Field& phi) {
  const double band_mm = static_cast<double>(kBandVoxels) * phi.spacing_mm.minCoeff();
  return band_mm > kHeld ? phi : signed_distance(negative_of(phi), phi);
}

/// Gives what lies within kHeld of a click to its side; between two clicks the nearer one decides. A click
/// inside whose ball does not touch the liver would make an island: it is left out, and segment() notes it.
void hold_clicks(const VolumeGrid& image, const Seeds& seeds, Field& phi) {
  const auto places = [&](const Points& points) {
    std::vector<Eigen::Vector3d> found;
    for (const Eigen::Vector3i& v : voxels_of(image, phi, points)) found.push_back(v.cast<double>());
    return found;
  };
  const std::vector<Eigen::Vector3d> inside = places(seeds.liver), outside = places(seeds.background);
  const auto nearest = [&](const std::vector<Eigen::Vector3d>& clicks, const Eigen::Vector3d& p) {
    double best = 1e9;
    for (const Eigen::Vector3d& click : clicks)
      best = std::min(best, (click - p).cwiseProduct(phi.spacing_mm).norm());
    return best;
  };
  const Field before = distances_of(phi);
  const auto hold = [&](const std::vector<Eigen::Vector3d>& own, const std::vector<Eigen::Vector3d>& others,
                        float side) {
    const Eigen::Vector3i reach =
        (kHeld * phi.spacing_mm.cwiseInverse()).array().ceil().matrix().cast<int>() + Eigen::Vector3i::Ones();
    for (const Eigen::Vector3d& click : own) {
      const Eigen::Vector3i middle = click.cast<int>();
      if (side < 0.0F && before.values[phi.offset(middle)] > static_cast<float>(kHeld)) continue;
      for (int k = -reach.z(); k <= reach.z(); ++k)
        for (int j = -reach.y(); j <= reach.y(); ++j)
          for (int i = -reach.x(); i <= reach.x(); ++i) {
            const Eigen::Vector3i v = middle + Eigen::Vector3i(i, j, k);
            if (!phi.contains(v)) continue;
            const double far = Eigen::Vector3d(i, j, k).cwiseProduct(phi.spacing_mm).norm();
            if (nearest(others, v.cast<double>()) < far) continue;
            float& value = phi.values[phi.offset(v)];
            const auto ball = static_cast<float>(far - kHeld);  // negative within
            value = side < 0.0F ? std::min(value, ball) : std::max(value, -ball);
          }
    }
  };
  hold(inside, outside, -1.0F);
  hold(outside, inside, 1.0F);
}

/// What lesions are looked for in, mm to each, negative inside, on the grid of the bodies.
struct LesionGround {
  Tissue liver;
  Field barred;
  std::optional<Field> organ, hull;  ///< the liver, and with its bites closed; none: not known yet
};

LesionGround ground_of(const Bodies& bodies) {
  Mask barred = bodies.cava;
  unite(barred, bodies.gallbladder);
  return {bodies.parenchyma, signed_distance(barred, bodies.grid), {}, {}};
}

/// Sigma of an abrupt border along a ray through a field of `spacing_mm`: the scanner's point spread, the
/// voxels that average, the triangle that resampled() filters with, and the interpolation between the field's
/// voxels; in the mean over all directions.
double blur_of(const VolumeGrid& image, double spacing_mm) {
  constexpr double kScanner = 0.7;  // mm: 1.6 mm of full width at half maximum, an abdominal kernel's
  const Eigen::Array3d voxel = image.spacing_mm, filter = voxel.max(spacing_mm);
  return std::sqrt(kScanner * kScanner + voxel.square().mean() / 12.0 + filter.square().mean() / 6.0 +
                   spacing_mm * spacing_mm / 6.0);
}

/// The surroundings of a lesion's clicks.
LesionScene lesion_scene(const Image& image, const Points& clicks, double diameter_mm,
                         const LesionGround& ground) {
  const VoxelBox box = box_around(image.grid, clicks, lesion_reach_mm(diameter_mm) + kLesionRim);
  LesionScene scene;
  scene.raw = resampled(image, box, kLesionVoxel);
  scene.blur_mm = blur_of(image.grid, kLesionVoxel);
  scene.ct = scene.raw;
  denoise(scene.ct);
  scene.liver = ground.liver;
  scene.barred = transferred(ground.barred, scene.ct);
  if (ground.organ) scene.organ = transferred(*ground.organ, scene.ct);
  if (ground.hull) scene.bites = transferred(*ground.hull, scene.ct);
  return scene;
}

/// Clicks in a lesion, and its diameter, mm; 0: not known.
struct ClickedLesion {
  PointsIn<CtFrame> at;
  double diameter_mm = 0.0;
};

ClickedLesion lesion_of(const Seeds& seeds, std::size_t n) {
  return {seeds.lesions[n], seeds.lesion_diameter_mm(n)};
}

std::vector<LesionClick> clicks_of(const Image& image, const LesionScene& scene,
                                   const ClickedLesion& lesion) {
  std::vector<LesionClick> clicks;
  for (const Eigen::Vector3i& place : voxels_of(image.grid, scene.ct, lesion.at))
    clicks.push_back({place, lesion.diameter_mm});
  return clicks;
}

/// Whether a click on the liver lies in something darker than it: a tumour or a cyst.
bool is_dark(const Field& ct, const Tissue& liver, const Eigen::Vector3i& click) {
  const double own = tissue_around(ct, {click}, kDarkClick, 0.0, kMostLiverSigma).mean;
  return own < liver.mean - kLiverWidth * liver.sigma && own > kEmptyTissue;
}

/// What is clicked of lesions, and by clicks on the liver: they bind, whatever they lie in.
std::vector<ClickedLesion> clicked_lesions(const Seeds& seeds, const Structures& anew, const Field& ct,
                                           const LiverSeeds& clicks) {
  std::vector<ClickedLesion> lesions;
  for (std::size_t n = 0; anew.lesions && n < seeds.lesions.size(); ++n)
    if (seeds.lesions[n].rows() > 0) lesions.push_back(lesion_of(seeds, n));
  const Tissue liver = liver_at(ct, clicks.inside);
  for (std::size_t n = 0; n < clicks.inside.size(); ++n)
    if (is_dark(ct, liver, clicks.inside[n]))
      lesions.push_back({PointsIn<CtFrame>(seeds.liver.row(static_cast<Eigen::Index>(n))), 0.0});
  return lesions;
}

/// Lesions before the liver is known. False: cancelled.
bool guess_lesions(const Image& image, const std::vector<ClickedLesion>& lesions, const Bodies& bodies,
                   const Field& ct, const RunContext& context, Mask& sure, Mask& likely) {
  const LesionGround ground = ground_of(bodies);
  std::vector<std::vector<LesionGuess>> guesses(lesions.size());
  share_out(guesses.size(), 2, [&](std::size_t n, bool) {
    if (context.cancelled()) return;
    const LesionScene scene = lesion_scene(image, lesions[n].at, lesions[n].diameter_mm, ground);
    for (const LesionClick& click : clicks_of(image, scene, lesions[n]))
      guesses[n].push_back(guess_lesion(scene, click));
  });
  for (const std::vector<LesionGuess>& lesion : guesses)
    for (const LesionGuess& guess : lesion) {
      if (!guess.sure.values.empty()) unite(sure, covered(guess.sure, ct));
      if (!guess.likely.values.empty()) unite(likely, covered(guess.likely, ct));
    }
  return !context.cancelled();
}

/// The surroundings of the clicks inside, out to farther than a liver reaches.
Cancellable<PartingView> parting_view(const Image& image, const Seeds& seeds, const RunContext& context) {
  const VoxelBox box = box_around(image.grid, seeds.liver, kLiverReach);
  PartingView view;
  view.raw = resampled(image, box, kParting);
  view.ct = view.raw;
  if (context.cancelled()) return std::nullopt;
  denoise(view.ct);
  return view;
}

/// The last moves of the contour once more, on voxels of `spacing_mm`.
Cancellable<bool> refine(const Image& image, const LiverSeeds& clicks, double spacing_mm, const Mask& tumours,
                         Bodies& bodies, const RunContext& context, const ShowContour& show) {
  const VoxelBox box = image_box(image.grid, bodies.grid, bodies.liver, 12.0);
  const double voxels = box.size().cast<double>().cwiseProduct(image.grid.spacing_mm).prod() /
                        (spacing_mm * spacing_mm * spacing_mm);
  if (voxels > kMostVoxels)
    throw InputError("options", "working_spacing_mm",
                     "would need " + std::to_string(std::lround(1e-6 * voxels)) + " million voxels",
                     "Choose a smaller region or a coarser spacing");
  Field ct = resampled(image, box, spacing_mm);
  smooth(ct, kFineBlur);
  if (context.cancelled()) return std::nullopt;
  denoise(ct);
  Mask barred = bodies.cava;
  unite(barred, bodies.gallbladder);
  const Mask never = transferred(smooth_boundary(barred, bodies.grid), ct);
  const Mask always = transferred(smooth_boundary(tumours, bodies.grid), ct);
  LiverSeeds fine_clicks;
  for (const Eigen::Vector3i& p : clicks.outside) {
    const Eigen::Vector3i v =
        ct.voxel_of(bodies.grid.first_index + p.cast<double>().cwiseProduct(bodies.grid.step));
    if (ct.contains(v)) fine_clicks.outside.push_back(v);
  }
  auto phi = refine_liver(ct, bodies.liver_phi, fine_clicks, never, always, context, show);
  if (!phi) return std::nullopt;
  bodies.liver_phi = std::move(*phi);
  correct(bodies.liver_phi, holes_filled(largest_component(negative_of(bodies.liver_phi))));
  return true;
}

/// Which lesion each dark voxel of the liver is: tumours that touch are parted at the neck between them.
/// @return 1 for the first lesion, ..., 0: none; empty: fewer than two are clicked.
std::vector<std::uint8_t> whose_lesion(const Image& image, const Seeds& seeds, const Field& ct,
                                       const Bodies& bodies) {
  std::vector<std::vector<Eigen::Vector3i>> places;
  for (const Points& lesion : seeds.lesions) places.push_back(voxels_of(image.grid, ct, lesion));
  if (std::ranges::count_if(places, [](const auto& lesion) { return !lesion.empty(); }) < 2) return {};
  Mask dark = ct.empty_mask();
  const auto limit = static_cast<float>(bodies.parenchyma.mean - kDarkSigmas * bodies.parenchyma.sigma);
  for (std::size_t i = 0; i < dark.voxels.size(); ++i)
    dark.voxels[i] = bodies.liver.voxels[i] != 0 && ct.values[i] < limit;
  return first_to_reach(dark, squared_depth_mm2(dark), places);
}

/// What is another lesion's, on the grid of a scene.
Mask of_others(const std::vector<std::uint8_t>& whose, std::size_t lesion, const Field& ct, const Field& to) {
  Mask others = ct.empty_mask();
  for (std::size_t i = 0; i < whose.size(); ++i) others.voxels[i] = whose[i] != 0 && whose[i] != lesion + 1;
  return transferred(smooth_boundary(others, ct), to);
}

/// The lesions in the liver that was found, or kept. @param ct denoised, on the grid of the bodies. False:
/// cancelled.
bool add_lesions(const Image& image, const Seeds& seeds, const Field& ct, Bodies& bodies,
                 const RunContext& context) {
  LesionGround ground = ground_of(bodies);
  ground.organ = bodies.liver_phi;
  ground.hull = signed_distance(with_bites(bodies.liver), bodies.grid);
  const std::vector<std::uint8_t> whose = whose_lesion(image, seeds, ct, bodies);
  bodies.lesions.resize(seeds.lesions.size());
  share_out(bodies.lesions.size(), 2, [&](std::size_t n, bool) {
    if (context.cancelled() || seeds.lesions[n].rows() == 0) return;
    LesionScene scene = lesion_scene(image, seeds.lesions[n], seeds.lesion_diameter_mm(n), ground);
    if (!whose.empty()) unite(scene.barred, of_others(whose, n, ct, scene.ct));
    GrownLesion& lesion = bodies.lesions[n];
    std::vector<Eigen::Vector3i> in_vain;
    for (const LesionClick& click : clicks_of(image, scene, lesion_of(seeds, n))) {
      GrownLesion one = grow_lesion(scene, click);
      if (one.phi.values.empty()) in_vain.push_back(click.place);
      lesion.bright = lesion.bright || one.bright;
      lesion.borderless = lesion.borderless || one.borderless;
      lesion.goes_on = lesion.goes_on || one.goes_on;
      lesion.unseen_mm = std::max(lesion.unseen_mm, one.unseen_mm);
      if (lesion.phi.values.empty()) {
        lesion.phi = std::move(one.phi);
        continue;
      }
      for (std::size_t i = 0; i < one.phi.values.size(); ++i)
        lesion.phi.values[i] = std::min(lesion.phi.values[i], one.phi.values[i]);
    }
    if (lesion.phi.values.empty()) return;
    lesion.clicks_in_vain =
        static_cast<int>(std::ranges::count_if(in_vain, [&](const Eigen::Vector3i& place) {
          return lesion.phi.values[lesion.phi.offset(place)] >= 0.0F;
        }));
  });
  return !context.cancelled();
}

}  // namespace

std::vector<Eigen::Vector3i> voxels_of(const VolumeGrid& image, const Field& field, const Points& points) {
  std::vector<Eigen::Vector3i> voxels;
  for (Eigen::Index n = 0; n < points.rows(); ++n) {
    const Eigen::Vector3d index = image.index_of(Point<CtFrame>(Eigen::Vector3d(points.row(n).transpose())));
    voxels.push_back(field.voxel_of(index).cwiseMax(0).cwiseMin(field.size - Eigen::Vector3i::Ones()));
  }
  return voxels;
}

bool is_anew(const Structures& anew, const Seeds& seeds, Label label) {
  switch (label) {
    case structure::kParenchyma:
      return anew.liver;
    case structure::kPortalVein:
      return anew.portal_vein;
    case structure::kHepaticVeins:
      return anew.hepatic_veins;
    case structure::kVenaCava:
      return anew.vena_cava;
    case structure::kGallbladder:
      return anew.gallbladder;
    default:
      break;
  }
  if (!is_lesion(label) || !anew.lesions) return false;
  const auto lesion = static_cast<std::size_t>(label - structure::kFirstLesion);
  return lesion < seeds.lesions.size() && seeds.lesions[lesion].rows() > 0;
}

bool is_found(const GrownLesion& lesion) {
  return !lesion.phi.values.empty() && negative_of(lesion.phi).count() > 0;
}

void unite(Mask& mask, const Mask& more) {
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    mask.voxels[i] = mask.voxels[i] != 0 || more.voxels[i] != 0;
}

Cancellable<Bodies> find_bodies(const Image& image, const Seeds& seeds, double spacing_mm,
                                const Structures& anew, const Kept* kept, const RunContext& context,
                                const ShowContour& show) {
  const auto prepared = [&context](double share) { context.progress(share, "segmentation.prepare"); };
  prepared(0.0);
  Field ct = resampled(image, {Eigen::Vector3i::Zero(), image.grid.size}, std::max(kCoarse, spacing_mm));
  prepared(0.03);
  denoise(ct);
  prepared(0.05);
  if (context.cancelled()) return std::nullopt;

  Bodies bodies;
  bodies.grid = ct;
  bodies.grid.values.clear();
  const auto places = [&](const Points& points) { return voxels_of(image.grid, ct, points); };
  const auto known = [&](const std::function<bool(Label)>& wanted) {
    return kept != nullptr ? kept_mask(kept->labels, ct, wanted) : ct.empty_mask();
  };
  LiverSeeds clicks{places(seeds.liver), places(seeds.background)};
  for (const Points& lesion : seeds.lesions)
    std::ranges::copy(places(lesion), std::back_inserter(clicks.lesions));
  if (anew.liver)
    bodies.parenchyma = tissue_at_clicks(ct, clicks.inside);
  else
    take_liver(*kept, ct, bodies);
  if (anew.vena_cava) {
    bodies.cava = follow_cava(ct, places(seeds.vena_cava), axis_along(image.grid, 2));
  } else {
    bodies.cava = known([](Label label) { return label == structure::kVenaCava; });
  }
  bodies.gallbladder = anew.gallbladder ? grow_body(ct, places(seeds.gallbladder), bodies.parenchyma)
                                        : known([](Label label) { return label == structure::kGallbladder; });
  Mask tumours = known([&](Label label) { return is_lesion(label) && !is_anew(anew, seeds, label); });
  if (!anew.liver) {
    if (anew.lesions && !add_lesions(image, seeds, ct, bodies, context)) return std::nullopt;
    return bodies;
  }
  prepared(0.06);
  Mask likely = ct.empty_mask();
  if (!guess_lesions(image, clicked_lesions(seeds, anew, ct, clicks), bodies, ct, context, tumours, likely))
    return std::nullopt;

  const bool fine = spacing_mm < kCoarse;
  Mask barred = bodies.cava;
  unite(barred, bodies.gallbladder);
  prepared(0.08);
  const auto view = parting_view(image, seeds, context);
  if (!view) return std::nullopt;
  auto contour =
      find_liver(ct, *view, clicks, barred, tumours, likely, context.part(0.1, fine ? 0.4 : 0.7), show);
  if (!contour) return std::nullopt;
  bodies.parenchyma = contour->parenchyma;
  bodies.doubtful = contour->doubtful;
  const auto whole = with_enclosed(ct, negative_of(contour->phi), contour->parenchyma, contour->like,
                                   contour->own, contour->closed_ground, tumours, likely, clicks,
                                   context.part(fine ? 0.4 : 0.7, fine ? 0.4 : 0.7));
  if (!whole) return std::nullopt;
  if (whole->count() == 0) return bodies;  // where the only clicks for and against it lie in one voxel
  auto settled = settle_liver(ct, *whole, *contour, clicks, tumours,
                              context.part(fine ? 0.4 : 0.7, fine ? 0.5 : 1.0), show);
  if (!settled) return std::nullopt;
  bodies.liver_phi = std::move(*settled);
  clean_up(bodies, tumours);
  if (fine && bodies.liver.count() > 0 &&
      !refine(image, clicks, spacing_mm, tumours, bodies, context.part(0.5, 1.0), show))
    return std::nullopt;
  if (bodies.liver.count() > 0) hold_clicks(image.grid, seeds, bodies.liver_phi);
  if (bodies.liver.count() > 0 && anew.lesions && !add_lesions(image, seeds, ct, bodies, context))
    return std::nullopt;
  std::vector<Eigen::Vector3i> seen = clicks.inside;
  seen.insert(seen.end(), clicks.lesions.begin(), clicks.lesions.end());
  bodies.dark = dark_bodies(ct, bodies, seen);
  return bodies;
}

}  // namespace glisson::segmentation
