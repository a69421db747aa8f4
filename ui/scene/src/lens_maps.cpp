// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/lens_maps.h"

#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"

namespace glisson::scene {
namespace {

/// Where a ray meets the undistorted picture that has the camera's own matrix.
Eigen::Vector2d pinhole_pixel(const Camera& camera, const Eigen::Vector3d& ray) {
  return (camera.matrix * ray).head<2>();
}

}  // namespace

LensMaps make_lens_maps(const Camera& camera) {
  require(camera.width > 0 && camera.height > 0 && camera.matrix(0, 0) > 0.0 && camera.matrix(1, 1) > 0.0,
          "a camera has a picture size and focal lengths");
  LensMaps maps;
  const auto pixels = static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
  maps.x.resize(pixels);
  maps.y.resize(pixels);
  // Nothing is drawn farther out than half a picture beyond each edge.
  const Eigen::Vector2d size(camera.width, camera.height);
  const Eigen::Vector2d lowest = -0.5 * size, highest = 1.5 * size;
  Eigen::Vector2d low(0.0, 0.0), high = size - Eigen::Vector2d::Ones();
  std::size_t i = 0;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u, ++i) {
      const Eigen::Vector2d p = pinhole_pixel(camera, camera.ray({u, v}));
      const bool usable =
          p.allFinite() && (p.array() >= lowest.array()).all() && (p.array() <= highest.array()).all();
      maps.x[i] = usable ? static_cast<float>(p.x()) : -1e4F;
      maps.y[i] = usable ? static_cast<float>(p.y()) : -1e4F;
      if (usable) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    }
  const Eigen::Vector2d shift = (-low).array().ceil().matrix();
  for (float& x : maps.x) x += static_cast<float>(shift.x());
  for (float& y : maps.y) y += static_cast<float>(shift.y());
  maps.pinhole.matrix = camera.matrix;
  maps.pinhole.matrix.block<2, 1>(0, 2) += shift;
  maps.pinhole.width = static_cast<int>(std::ceil(high.x() + shift.x())) + 1;
  maps.pinhole.height = static_cast<int>(std::ceil(high.y() + shift.y())) + 1;
  return maps;
}

}  // namespace glisson::scene
