// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/patient/patient_model.h"
#include "glisson/patient/picture.h"
#include "glisson/ui/scene/lens_maps.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "overlay_layers.h"

namespace glisson::scene {

/// Bends the layers with the lens and lays them over the frame. Everything outside the liver's silhouette is
/// left as it is.
Picture blend_layers(const Picture& frame, const LayerRasters& layers, const LensMaps& lens,
                     const OverlayStyle& style);

}  // namespace glisson::scene
