// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QPolygonF>
#include <optional>
#include <vector>

#include "canvas.h"
#include "glisson/patient/registration.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "glisson/volume/label_volume.h"
#include "lesion_card.h"

namespace glisson::scene {

/// Lines and words on the picture; where the lens puts them was computed before.
struct Annotations {
  std::vector<std::vector<Eigen::Vector2d>> margin;  ///< pixels, in order; a piece each time it is in sight
  std::vector<Label> structures;                     ///< drawn ones, for the legend
  std::vector<LesionVerdict> lesions;                ///< those that are wanted
  std::vector<QPolygonF> regions;                    ///< one a lesion, pixels; empty: none is drawn
  std::optional<LesionCard> card;                    ///< of the chosen one
  Camera camera;
};
void annotate(Canvas& picture, const OverlayFrame& overlay, const Annotations& annotations,
              const OverlayStyle& style, const OverlayStatus& status);

}  // namespace glisson::scene
