// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_walk.h"

#include <Eigen/Geometry>
#include <limits>

namespace glisson::experiments {
namespace {
using Eigen::Vector3d;

constexpr double kNothing = 1e-12;  // metres

/// The part of a direction in a triangle's plane, of length 1.
Vector3d within(const Vector3d& direction, const Vector3d& normal) {
  return (direction - direction.dot(normal) * normal).normalized();
}

}  // namespace

SurfaceWalk::SurfaceWalk(const TriangleMesh& surface) : surface_(surface) {
  for (int t = 0; t < surface.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k)
      triangle_left_of_[{surface.triangles(t, k), surface.triangles(t, (k + 1) % 3)}] = t;
}

Vector3d SurfaceWalk::walk(const ClosestPoint& from, const Vector3d& direction, double length) const {
  int triangle = from.triangle, came_over = -1;  // the corner opposite to the edge that was crossed
  Vector3d at = from.point, way = direction;
  for (int crossed = 0; length > kNothing && crossed < surface_.triangle_count(); ++crossed) {
    const auto corner = [&](int k) { return surface_.vertex(surface_.triangles(triangle, k % 3)); };
    const Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    way = within(way, normal);
    double reach = length;
    int exit = -1;
    for (int k = 0; k < 3; ++k) {
      const Vector3d inward = normal.cross(corner(k + 2) - corner(k + 1)).normalized();
      const double towards = -way.dot(inward);
      if (k == came_over || towards <= 0.0) continue;
      const double distance = std::max(0.0, (at - corner(k + 1)).dot(inward)) / towards;
      if (distance < reach) {
        reach = distance;
        exit = k;
      }
    }
    at += reach * way;
    length -= reach;
    if (exit < 0) break;
    const int a = surface_.triangles(triangle, (exit + 1) % 3),
              b = surface_.triangles(triangle, (exit + 2) % 3);
    const Vector3d edge = (surface_.vertex(b) - surface_.vertex(a)).normalized();
    const double along = way.dot(edge), over = std::sqrt(std::max(0.0, 1.0 - along * along));
    triangle = triangle_left_of_.at({b, a});
    came_over = 0;
    while (surface_.triangles(triangle, came_over) == a || surface_.triangles(triangle, came_over) == b)
      ++came_over;
    way = along * edge + over * within(corner(came_over) - surface_.vertex(a), edge);
  }
  return at;
}

}  // namespace glisson::experiments
