// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "canvas.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "overlay_layers.h"

namespace glisson::scene {

/// Lays the layers over the frame. Everything outside the liver's silhouette is left as it is.
/// @param focus what is looked at, pixel.
void blend_layers(Canvas& frame, const OverlayLayers& layers, const OverlayStyle& style,
                  const std::optional<Eigen::Vector2d>& focus);

}  // namespace glisson::scene
