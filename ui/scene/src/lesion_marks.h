// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/patient/registration.h"

namespace glisson::scene {

/// One verdict for each lesion of the model, none better than the whole's; one that nobody judged is
/// withdrawn.
std::vector<LesionVerdict> verdicts_of(const std::vector<Label>& lesions, const OverlayFrame& overlay);

/// Where the whole lesion lies in 95 of 100 cases: the ellipse of its centre's place on the picture, widened
/// all round by the lesion's radius. Pixels; empty: behind the camera, or nothing is known.
QPolygonF region_of(const LesionVerdict& verdict, const Camera& camera);

}  // namespace glisson::scene
