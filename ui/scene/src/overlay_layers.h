// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/ui/scene/drawable_model.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "glisson/ui/scene/surface_raster.h"

namespace glisson::scene {

/// What a pixel of the layer of vessels shows.
enum VesselKind : std::uint8_t { kNoVessel = 0, kPortal = 1, kHepatic = 2, kArterial = 3 };

/// What the camera would see of the deformed model, class by class. Kinds of lesions are their labels.
struct OverlayLayers {
  /// @param camera that sees them.
  explicit OverlayLayers(const Camera& camera);

  SurfaceLayer liver, vessels, lesions;
  std::vector<float> sight;  ///< of each pixel's ray, metres along it for one along the camera's axis
  std::vector<ProjectedSurface> projected;  ///< memory for draw_layers()
  std::vector<std::uint8_t> veil;           ///< memory for blend_layers()
};

/// Draws into layers that may hold a former picture: what is there is taken away, its memory is used again.
/// @param nodes_in_camera N x 3, metres. @pre one row a node of the model's mesh.
/// @param style structures that it leaves out are not drawn and hide nothing.
/// @param lesions those that are drawn as bodies.
void draw_layers(const DrawableModel& model, const Points& nodes_in_camera, const SurfaceRaster& raster,
                 const OverlayStyle& style, const std::vector<Label>& lesions, OverlayLayers& layers);

}  // namespace glisson::scene
