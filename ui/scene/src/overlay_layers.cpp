// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlay_layers.h"

#include <algorithm>
#include <array>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"

namespace glisson::scene {
namespace {

constexpr std::uint8_t kSomething = 1;  ///< the liver needs no kinds
static_assert(structure::kLastLesion <= 255, "a lesion's label is its kind");

VesselKind vessel_kind(Label structure) {
  switch (structure) {
    case structure::kPortalVein:
      return kPortal;
    case structure::kHepaticVeins:
      return kHepatic;
    case structure::kArtery:
      return kArterial;
    default:
      return kNoVessel;
  }
}

bool is_wanted(Label structure, const OverlayStyle& style, const std::vector<Label>& lesions) {
  switch (vessel_kind(structure)) {
    case kPortal:
      return style.portal_vein;
    case kHepatic:
      return style.hepatic_veins;
    case kArterial:
      return style.arteries;
    case kNoVessel:
      break;
  }
  return !is_lesion(structure) || std::find(lesions.begin(), lesions.end(), structure) != lesions.end();
}

std::uint8_t kind_of(Label structure) {
  if (is_lesion(structure)) return static_cast<std::uint8_t>(structure);
  const VesselKind vessel = vessel_kind(structure);
  return vessel == kNoVessel ? kSomething : std::uint8_t{vessel};
}

/// A surface on its way into a layer.
struct Work {
  const DrawableSurface* surface;
  std::size_t layer;
  std::uint8_t kind;
};

/// A smooth function over the picture: one ray for some pixels and their mean between is exact to a
/// thousandth.
std::vector<float> lengths_of_rays(const Camera& camera) {
  constexpr int kCoarse = 8;  // pixels
  cv::Mat1f coarse((camera.height + kCoarse - 1) / kCoarse, (camera.width + kCoarse - 1) / kCoarse);
  for (int row = 0; row < coarse.rows; ++row)
    for (int column = 0; column < coarse.cols; ++column) {
      const auto ray = camera.mapped_ray(kCoarse * Eigen::Vector2d(column + 0.5, row + 0.5) -
                                         Eigen::Vector2d::Constant(0.5));
      coarse(row, column) =
          ray ? static_cast<float>(ray->norm() / ray->z()) : 1.0F;  // nothing is drawn there
    }
  cv::Mat1f fine;
  cv::resize(coarse, fine, coarse.size() * kCoarse, 0.0, 0.0, cv::INTER_LINEAR);
  std::vector<float> lengths;
  lengths.reserve(static_cast<std::size_t>(camera.height) * static_cast<std::size_t>(camera.width));
  for (int row = 0; row < camera.height; ++row)
    lengths.insert(lengths.end(), fine[row], fine[row] + camera.width);
  return lengths;
}

constexpr std::size_t kLayers = 3;  ///< liver, vessels, lesions

std::optional<std::size_t> layer_of(Label structure) {
  if (structure == structure::kParenchyma) return 0;
  if (vessel_kind(structure) != kNoVessel) return 1;
  if (is_lesion(structure)) return 2;
  return {};
}

std::vector<Work> work_of(const DrawableModel& model, const OverlayStyle& style,
                          const std::vector<Label>& lesions) {
  std::vector<Work> all;
  for (const DrawableSurface* surface : drawn_surfaces(model, style.thin_branches)) {
    const auto layer = layer_of(surface->structure);
    if (surface->inside.triangles.rows() == 0 || !layer || !is_wanted(surface->structure, style, lesions))
      continue;
    all.push_back({surface, *layer, kind_of(surface->structure)});
  }
  return all;
}

/// Does each of `count` things, as many at a time as there are processors.
template <class Thing>
void side_by_side(std::size_t count, const Thing& thing) {
  const int whole = static_cast<int>(count);
  cv::parallel_for_(
      cv::Range(0, whole),
      [&](const cv::Range& range) {
        for (int i = range.start; i < range.end; ++i) thing(static_cast<std::size_t>(i));
      },
      whole);
}

/// Rows of one layer.
struct Part {
  std::size_t layer;
  RowBand band;
  PixelBox touched;
};

/// Bands of each layer, so that each processor has its share whatever structure is the largest.
std::vector<Part> parts_of(const std::vector<Work>& all, const std::vector<ProjectedSurface>& projected,
                           int height) {
  std::vector<Part> parts;
  for (std::size_t layer = 0; layer < kLayers; ++layer) {
    std::vector<const ProjectedSurface*> surfaces;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].layer == layer) surfaces.push_back(&projected[i]);
    if (surfaces.empty()) continue;
    for (const RowBand& band : row_bands(surfaces, height, std::max(1, cv::getNumThreads())))
      parts.push_back({layer, band, {}});
  }
  return parts;
}

}  // namespace

OverlayLayers::OverlayLayers(const Camera& camera) : sight(lengths_of_rays(camera)) {}

void draw_layers(const DrawableModel& model, const Points& nodes_in_camera, const SurfaceRaster& raster,
                 const OverlayStyle& style, const std::vector<Label>& lesions, OverlayLayers& layers) {
  require(nodes_in_camera.rows() == model.model->mesh.vertex_count(),
          "the overlay's nodes are those of the model that it was made for");
  const std::array<SurfaceLayer*, kLayers> targets = {&layers.liver, &layers.vessels, &layers.lesions};
  const std::vector<Work> all = work_of(model, style, lesions);
  layers.projected.resize(all.size());
  side_by_side(kLayers + all.size(), [&](std::size_t i) {
    if (i < kLayers) return raster.clear(*targets[i]);
    const Work& work = all[i - kLayers];
    raster.project(work.surface->binding.apply(model.model->mesh, nodes_in_camera),
                   work.surface->inside.triangles, layers.projected[i - kLayers]);
  });
  std::vector<Part> parts = parts_of(all, layers.projected, layers.liver.height);
  side_by_side(parts.size(), [&](std::size_t p) {
    Part& part = parts[p];
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].layer == part.layer)
        part.touched.add(raster.fill(layers.projected[i], all[i].surface->inside, all[i].kind, part.band,
                                     *targets[part.layer]));
  });
  for (const Part& part : parts) targets[part.layer]->touched.add(part.touched);
}

}  // namespace glisson::scene
