// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "glisson/geometry/camera.h"
#include "glisson/guidance/lesion_meter.h"
#include "glisson/patient/registration.h"
#include "overlay_layout.h"

namespace glisson::scene {

/// What a person wants to know of the lesion that they chose.
struct LesionCard {
  LesionVerdict verdict;
  guidance::LesionMeasures measures;
  std::optional<Eigen::Vector2d> place;  ///< marked, pixels
};

/// Brackets around the lesion, the marked place, the shortest way to the surface as a ruler with a tick every
/// 10 mm. Nothing points to where a withdrawn lesion would be.
void draw_card_marks(QPainter& painter, const Layout& layout, const LesionCard& card, const Camera& camera,
                     bool with_ruler);
/// The numbers at the right border, over what stands there; of a withdrawn lesion the reason alone.
void draw_card(QPainter& painter, const Layout& layout, Taken& taken, const LesionCard& card);

}  // namespace glisson::scene
