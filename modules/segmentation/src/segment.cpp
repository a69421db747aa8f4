// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/segment.h"

#include <algorithm>
#include <cmath>

#include "field.h"
#include "glisson/core/error.h"
#include "level_set.h"
#include "liver.h"
#include "organs.h"
#include "vessels.h"

namespace glisson::segmentation {
namespace {

constexpr double kVesselSpacing = 1.0;  // mm
constexpr double kDiffusion = 15.0;     // HU: noise is below, edges are above
constexpr int kDiffusionSteps = 10;
/// HU, from a very fatty liver to far above any enhancement: outside it the clicks, or the units, are wrong.
constexpr double kLeastLiver = -10.0, kMostLiver = 250.0;

void check_points(const Image& image, const Points& points, const char* name) {
  for (Eigen::Index n = 0; n < points.rows(); ++n) {
    const Point<CtFrame> p{Eigen::Vector3d(points.row(n).transpose())};
    const Eigen::Vector3d index = image.grid.index_of(p);
    if (!index.allFinite() ||
        !image.grid.contains(index.array().round().max(-1.0).min(1e6).matrix().cast<int>()))
      throw InputError("seeds", std::string(name) + " " + std::to_string(n + 1), "lies outside the image",
                       "Check that the seeds belong to this image and are in mm (LPS)");
  }
}

void check_input(const Image& image, const Seeds& seeds) {
  if (image.empty()) throw InputError("image", "", "is empty", "Import a CT first");
  if (image.modality != Modality::ct)
    throw InputError("image", "modality", "is not CT, and the statistics are those of Hounsfield units",
                     "Import a portal venous CT, or import labels instead");
  if (seeds.liver.rows() == 0)
    throw InputError("seeds", "liver", "has no point", "Click at least one point inside the liver");
  check_points(image, seeds.liver, "liver");
  check_points(image, seeds.portal_vein, "portal_vein");
  check_points(image, seeds.hepatic_veins, "hepatic_veins");
  check_points(image, seeds.vena_cava, "vena_cava");
  check_points(image, seeds.gallbladder, "gallbladder");
  check_points(image, seeds.background, "background");
  for (const Points& lesion : seeds.lesions) check_points(image, lesion, "lesions");
  if (seeds.lesions.size() > structure::kLastLesion - structure::kFirstLesion + 1U)
    throw InputError("seeds", "lesions", "are more than there are labels for", "Click the largest ones");
}

std::vector<Eigen::Vector3i> voxels_of(const Image& image, const Field& field, const Points& points) {
  std::vector<Eigen::Vector3i> voxels;
  for (Eigen::Index n = 0; n < points.rows(); ++n) {
    const Eigen::Vector3d index =
        image.grid.index_of(Point<CtFrame>(Eigen::Vector3d(points.row(n).transpose())));
    voxels.push_back(field.voxel_of(index).cwiseMax(0).cwiseMin(field.size - Eigen::Vector3i::Ones()));
  }
  return voxels;
}

/// The image's axis that runs most nearly from foot to head.
int long_axis(const VolumeGrid& grid) {
  int axis = 0;
  grid.direction.row(2).cwiseAbs().maxCoeff(&axis);
  return axis;
}

void unite(Mask& mask, const Mask& more) {
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    mask.voxels[i] = mask.voxels[i] != 0 || more.voxels[i] != 0;
}

Mask negative_of(const Field& phi) {
  Mask mask = phi.empty_mask();
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) mask.voxels[i] = phi.values[i] < 0.0F ? 1 : 0;
  return mask;
}

/// Everything found at the working resolution.
struct Bodies {
  Field liver_phi;  ///< lesions united, holes filled, one piece
  Tissue parenchyma;
  Mask liver, cava, gallbladder;
  std::vector<Mask> lesions;
};

/// One piece without holes, tumours included; thin wedges between them and the contour closed.
void clean_up(Bodies& bodies) {
  Mask liver = negative_of(bodies.liver_phi);
  for (const Mask& lesion : bodies.lesions) unite(liver, lesion);
  liver = holes_filled(largest_component(opened(liver, 2.0)));
  Mask tumours = bodies.liver_phi.empty_mask();
  for (const Mask& lesion : bodies.lesions) unite(tumours, lesion);
  if (tumours.count() > 0) {
    const Mask near = dilated(tumours, 8.0), bridged = closed(liver, 6.0);
    for (std::size_t i = 0; i < liver.voxels.size(); ++i)
      if (near.voxels[i] != 0 && bridged.voxels[i] != 0) liver.voxels[i] = 1;
  }
  for (std::size_t i = 0; i < liver.voxels.size(); ++i)
    if (bodies.cava.voxels[i] != 0 || bodies.gallbladder.voxels[i] != 0) liver.voxels[i] = 0;
  liver = holes_filled(largest_component(liver));
  // The contour's own sub-voxel boundary where nothing was changed, the mask's elsewhere.
  const Field distance = signed_distance(liver, bodies.liver_phi);
  for (std::size_t i = 0; i < liver.voxels.size(); ++i) {
    float& phi = bodies.liver_phi.values[i];
    if ((phi < 0.0F) != (liver.voxels[i] != 0)) phi = distance.values[i];
  }
  bodies.liver = liver;
}

Cancellable<Bodies> find_bodies(const Image& image, const Seeds& seeds, const SegmentationOptions& options,
                                const RunContext& context) {
  context.progress(0.0, "segmentation.prepare");
  Field ct = resampled(image, {Eigen::Vector3i::Zero(), image.grid.size}, options.working_spacing_mm);
  diffuse(ct, kDiffusion, kDiffusionSteps);
  if (context.cancelled()) return std::nullopt;

  Bodies bodies;
  const LiverSeeds clicks{voxels_of(image, ct, seeds.liver), voxels_of(image, ct, seeds.background)};
  const Tissue liver = tissue_around(ct, clicks.inside, 6.0, 3.0, 15.0);
  if (liver.mean < kLeastLiver || liver.mean > kMostLiver)
    throw InputError("seeds", "liver",
                     "lies in tissue of " + std::to_string(std::lround(liver.mean)) +
                         " HU, which no liver has in the portal venous phase",
                     "Click inside the parenchyma of a CT in Hounsfield units");
  bodies.cava = ct.empty_mask();
  if (seeds.vena_cava.rows() > 0)
    bodies.cava = follow_cava(ct, voxels_of(image, ct, seeds.vena_cava), long_axis(image.grid));
  bodies.gallbladder = grow_body(ct, voxels_of(image, ct, seeds.gallbladder), liver);
  Mask included = ct.empty_mask();
  for (const Points& lesion : seeds.lesions) {
    bodies.lesions.push_back(grow_body(ct, voxels_of(image, ct, lesion), liver));
    unite(included, bodies.lesions.back());
  }
  Mask barred = bodies.cava;
  unite(barred, bodies.gallbladder);
  auto contour = find_liver(ct, clicks, barred, included, context.part(0.1, 1.0));
  if (!contour) return std::nullopt;
  bodies.liver_phi = std::move(contour->phi);
  bodies.parenchyma = contour->parenchyma;
  clean_up(bodies);
  return bodies;
}

/// A mask of the working grid as a smooth function, negative inside, at about half a voxel.
Field smooth_boundary(const Mask& mask, const Field& grid) {
  Field phi = signed_distance(mask, grid);
  smooth(phi, 0.5 * grid.spacing_mm.minCoeff());
  return phi;
}

/// Labels being painted on the image's grid, within a box.
struct Painting {
  VoxelBox box;
  std::vector<Label> labels;
  void paint(const Field& phi, Label label) {
    const std::vector<float> values = on_image(phi, box);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] < 0.0F) labels[i] = label;
  }
};

/// The image's voxels that the set voxels of `mask` cover, and a margin.
VoxelBox image_box(const Image& image, const Field& grid, const Mask& mask, double margin_mm) {
  const VoxelBox inner = bounding_box(mask.size, mask.spacing_mm, mask.voxels, margin_mm);
  VoxelBox box;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = grid.first_index[axis] + grid.step[axis] * (inner.low[axis] - 1);
    const double high = grid.first_index[axis] + grid.step[axis] * inner.high[axis];
    box.low[axis] = std::clamp(static_cast<int>(std::floor(low)), 0, image.grid.size[axis] - 1);
    box.high[axis] =
        std::clamp(static_cast<int>(std::ceil(high)) + 1, box.low[axis] + 1, image.grid.size[axis]);
  }
  return box;
}

/// A mask of one field on the grid of another, both along the image's axes.
Mask transferred(const Field& phi, const Field& to) {
  Mask mask = to.empty_mask();
  std::size_t at = 0;
  for (int k = 0; k < to.size.z(); ++k)
    for (int j = 0; j < to.size.y(); ++j)
      for (int i = 0; i < to.size.x(); ++i, ++at) {
        const Eigen::Vector3d index = to.first_index + Eigen::Vector3d(i, j, k).cwiseProduct(to.step);
        const Eigen::Vector3i v =
            phi.voxel_of(index).cwiseMax(0).cwiseMin(phi.size - Eigen::Vector3i::Ones());
        mask.voxels[at] = phi.values[phi.offset(v)] < 0.0F ? 1 : 0;
      }
  return mask;
}

double ml_of(const LabelVolume& labels, Label label) {
  const std::vector<long> counts = labels.histogram();
  return label < counts.size() ? 1e-3 * static_cast<double>(counts[label]) * labels.grid().voxel_volume_mm3()
                               : 0.0;
}

Segmented finish(const Image& image, const Painting& painting, const Seeds& seeds) {
  std::vector<Label> dense(static_cast<std::size_t>(image.grid.voxel_count()), 0);
  std::size_t at = 0;
  for (int k = painting.box.low.z(); k < painting.box.high.z(); ++k)
    for (int j = painting.box.low.y(); j < painting.box.high.y(); ++j)
      for (int i = painting.box.low.x(); i < painting.box.high.x(); ++i)
        dense[static_cast<std::size_t>(image.grid.offset({i, j, k}))] = painting.labels[at++];
  Segmented result;
  result.labels.voxels = LabelVolume(image.grid, dense);
  const std::vector<long> counts = result.labels.voxels.histogram();
  for (std::size_t label = 1; label < counts.size(); ++label)
    if (counts[label] > 0) {
      const auto code = static_cast<Label>(label);
      result.labels.infos.push_back(structure_info(code));
    }
  const std::vector<std::uint8_t> liver = inside_liver(result.labels);
  result.report.liver_ml =
      1e-3 * static_cast<double>(std::count(liver.begin(), liver.end(), 1)) * image.grid.voxel_volume_mm3();
  result.report.portal_ml = ml_of(result.labels.voxels, structure::kPortalVein);
  result.report.hepatic_ml = ml_of(result.labels.voxels, structure::kHepaticVeins);
  for (std::size_t n = 0; n < seeds.lesions.size(); ++n)
    result.report.lesion_ml.push_back(
        ml_of(result.labels.voxels, static_cast<Label>(structure::kFirstLesion + n)));
  return result;
}

/// Codes, not sentences: what a person should look at.
void note_doubts(const Seeds& seeds, SegmentationReport& report) {
  if (report.liver_ml < 400.0) report.notes.emplace_back("liver.small");
  if (report.liver_ml > 4000.0) report.notes.emplace_back("liver.large");
  if (seeds.portal_vein.rows() > 0 && report.portal_ml == 0.0)
    report.notes.emplace_back("portal_vein.not_found");
  if (seeds.hepatic_veins.rows() > 0 && report.hepatic_ml == 0.0)
    report.notes.emplace_back("hepatic_veins.not_found");
  for (std::size_t n = 0; n < report.lesion_ml.size(); ++n)
    if (report.lesion_ml[n] == 0.0) report.notes.push_back("lesion_" + std::to_string(n + 1) + ".not_found");
}

}  // namespace

void SegmentationOptions::validate() const {
  if (!(working_spacing_mm >= 0.5 && working_spacing_mm <= 5.0))
    throw InputError("options", "working_spacing_mm", "is " + std::to_string(working_spacing_mm),
                     "Choose 0.5 to 5 mm");
}

Cancellable<Segmented> segment(const Image& image, const Seeds& seeds, const SegmentationOptions& options,
                               const RunContext& context) {
  options.validate();
  check_input(image, seeds);
  const auto bodies = find_bodies(image, seeds, options, context.part(0.0, 0.6));
  if (!bodies) return std::nullopt;
  if (bodies->liver.count() == 0)
    throw InputError("seeds", "liver", "grow to nothing: the clicks do not lie in liver tissue",
                     "Click inside the parenchyma, away from vessels and lesions");

  Mask everything = bodies->liver;
  unite(everything, bodies->cava);
  unite(everything, bodies->gallbladder);
  const VoxelBox box = image_box(image, bodies->liver_phi, everything, 15.0);
  const Field fine = [&] {
    Field field = resampled(image, box, kVesselSpacing);
    smooth(field, 0.7);
    return field;
  }();
  if (context.cancelled()) return std::nullopt;
  const Field cava_phi = smooth_boundary(bodies->cava, bodies->liver_phi);
  const auto vessels = find_vessels(
      fine, transferred(bodies->liver_phi, fine), transferred(cava_phi, fine), bodies->parenchyma,
      {voxels_of(image, fine, seeds.portal_vein), voxels_of(image, fine, seeds.hepatic_veins)},
      context.part(0.6, 0.95));
  if (!vessels) return std::nullopt;
  context.progress(0.95, "segmentation.finish");

  // What is painted later covers what was painted before.
  Painting painting{box, std::vector<Label>(static_cast<std::size_t>(box.size().prod()), 0)};
  painting.paint(bodies->liver_phi, structure::kParenchyma);
  // Not smoothed: a branch of one voxel would vanish.
  painting.paint(signed_distance(vessels->hepatic, fine), structure::kHepaticVeins);
  painting.paint(signed_distance(vessels->portal, fine), structure::kPortalVein);
  if (bodies->cava.count() > 0) painting.paint(cava_phi, structure::kVenaCava);
  if (bodies->gallbladder.count() > 0)
    painting.paint(smooth_boundary(bodies->gallbladder, bodies->liver_phi), structure::kGallbladder);
  for (std::size_t n = 0; n < bodies->lesions.size(); ++n)
    painting.paint(smooth_boundary(bodies->lesions[n], bodies->liver_phi),
                   static_cast<Label>(structure::kFirstLesion + n));
  Segmented result = finish(image, painting, seeds);
  note_doubts(seeds, result.report);
  context.progress(1.0, "segmentation.finish");
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
