// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/ui/scene/drawable_model.h"
#include "glisson/ui/scene/offscreen_renderer.h"

namespace glisson::scene {

/// The classes of things that are told apart in the drawn layers; each shades one colour channel.
enum class Channel { red = 0, green = 1, blue = 2 };

/// What VTK draws of the deformed model, through a pinhole: three pictures with depth.
struct LayerRasters {
  Raster liver;    ///< its depth is what counts
  Raster vessels;  ///< red: portal vein, green: hepatic veins, blue: arteries; the value is the shading
  Raster lesions;  ///< any channel: shading
};

/// The model's structures as VTK shapes that follow the nodes. Not thread-safe.
class OverlayLayers {
 public:
  /// @param pinhole the undistorted view that is drawn.
  OverlayLayers(std::shared_ptr<const DrawableModel> model, const Camera& pinhole);
  ~OverlayLayers();

  /// @param nodes_in_camera N x 3, metres. @pre one row a node of the model's mesh.
  LayerRasters draw(const Points& nodes_in_camera);

  static constexpr double kNear = 0.005, kFar = 2.0;  ///< metres

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::scene
