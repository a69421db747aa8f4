// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/registration.h"

/// What the tests of the overlay draw over, and where.
namespace glisson {

inline Picture grey_frame(const Camera& camera) {
  return {camera.width, camera.height, 3,
          std::make_shared<std::vector<std::uint8_t>>(
              static_cast<std::size_t>(3 * camera.width * camera.height), std::uint8_t{90})};
}

/// Valid, and its first lesion, too.
inline OverlayFrame at(const Points& nodes) {
  OverlayFrame overlay;
  overlay.validity = Validity::valid;
  overlay.nodes_in_camera = nodes;
  LesionVerdict lesion;
  lesion.lesion = structure::kFirstLesion;
  lesion.level = Level::valid;
  lesion.reason = LesionReason::known;
  overlay.lesions = {lesion};
  return overlay;
}

}  // namespace glisson
