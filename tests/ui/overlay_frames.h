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

/// Centre of what differs between two pictures.
inline Eigen::Vector2d centre_of_change(const Picture& a, const Picture& b, int* count = nullptr) {
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  int changed = 0;
  for (int v = 0; v < a.height; ++v)
    for (int u = 0; u < a.width; ++u) {
      const auto i = static_cast<std::size_t>(3 * (v * a.width + u));
      if ((*a.bytes)[i] == (*b.bytes)[i] && (*a.bytes)[i + 1] == (*b.bytes)[i + 1] &&
          (*a.bytes)[i + 2] == (*b.bytes)[i + 2])
        continue;
      low = low.cwiseMin(Eigen::Vector2d(u, v));
      high = high.cwiseMax(Eigen::Vector2d(u, v));
      ++changed;
    }
  if (count != nullptr) *count = changed;
  return 0.5 * (low + high);
}

}  // namespace glisson
