// SPDX-License-Identifier: GPL-3.0-or-later
#include "seen_parts.h"

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "glisson/stereo/source.h"
#include "picture_view.h"

namespace glisson::guidance {
namespace {

Picture circle_of(const Picture& view, const Camera& camera, const char* name) {
  require_view(view, camera, name);
  const auto circle = stereo::find_scope_circle(view);
  return circle ? stereo::circle_mask(*circle, view.width, view.height) : Picture();
}

Picture both(const Picture& circle, const Picture& mask) {
  if (mask.empty()) return circle;
  const cv::Mat wanted = grey_of(mask) > 0;
  const cv::Mat common = circle.empty() ? wanted : cv::Mat(wanted & grey_of(circle));
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(common.datastart, common.dataend);
  return {common.cols, common.rows, 1, std::move(bytes)};
}

}  // namespace

SeenParts seen_parts(const StereoFrame& first, const StereoRig& rig, const Picture& mask) {
  if (!mask.empty()) require_view(mask, rig.left, "mask");
  SeenParts parts;
  parts.left = circle_of(first.left, rig.left, "left view");
  parts.right = circle_of(first.right, rig.right, "right view");
  parts.tissue = both(parts.left, mask);
  return parts;
}

double seen_area(const TriangleMesh& mesh, const Camera& camera) {
  const Eigen::VectorXd areas = triangle_areas(mesh);
  double sum = 0.0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Vector3d a = mesh.vertex(mesh.triangles(t, 0)), b = mesh.vertex(mesh.triangles(t, 1)),
                          c = mesh.vertex(mesh.triangles(t, 2)), centre = (a + b + c) / 3.0;
    if (centre.z() > 0.0 && (b - a).cross(c - a).dot(centre) < 0.0 && camera.sees(camera.project(centre)))
      sum += areas[t];
  }
  return sum;
}

}  // namespace glisson::guidance
