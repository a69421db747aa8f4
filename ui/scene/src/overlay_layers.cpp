// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlay_layers.h"

#include <algorithm>
#include <array>
#include <opencv2/core/utility.hpp>
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

}  // namespace

void draw_layers(const DrawableModel& model, const Points& nodes_in_camera, const SurfaceRaster& raster,
                 const OverlayStyle& style, const std::vector<Label>& lesions, OverlayLayers& layers) {
  require(nodes_in_camera.rows() == model.model->mesh.vertex_count(),
          "the overlay's nodes are those of the model that it was made for");
  std::array<std::vector<const DrawableSurface*>, 3> groups;  // liver, vessels, lesions
  for (const DrawableSurface& surface : model.surfaces) {
    if (surface.inside.rows() == 0 || !is_wanted(surface.structure, style, lesions)) continue;
    if (surface.structure == structure::kParenchyma)
      groups[0].push_back(&surface);
    else if (vessel_kind(surface.structure) != kNoVessel)
      groups[1].push_back(&surface);
    else if (is_lesion(surface.structure))
      groups[2].push_back(&surface);
  }
  const std::array<SurfaceLayer*, 3> targets = {&layers.liver, &layers.vessels, &layers.lesions};
  cv::parallel_for_(cv::Range(0, 3), [&](const cv::Range& range) {
    for (int g = range.start; g < range.end; ++g) {
      const auto group = static_cast<std::size_t>(g);
      raster.clear(*targets[group]);
      for (const DrawableSurface* surface : groups[group]) {
        const Points moved = surface->binding.apply(model.model->mesh, nodes_in_camera);
        raster.draw(moved, style.thin_branches ? surface->inside : surface->thick,
                    kind_of(surface->structure), *targets[group]);
      }
    }
  });
}

}  // namespace glisson::scene
