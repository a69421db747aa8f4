// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "canvas.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "overlay_layers.h"

namespace glisson::scene {

/// Lays the layers over the frame. Everything outside the liver's silhouette, its outline and the window
/// around what is looked at is left as it is. The layers may be those of a reduced camera (reduced()): what
/// is laid over is made at their size, and grows with the picture; the frame keeps its own.
/// @param focus what is looked at, pixel of the frame. @param layers their veil is written.
void blend_layers(Canvas& frame, OverlayLayers& layers, const OverlayStyle& style,
                  const std::optional<Eigen::Vector2d>& focus);

}  // namespace glisson::scene
