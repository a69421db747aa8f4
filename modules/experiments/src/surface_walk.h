// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>

#include "glisson/geometry/closest_point_tree.h"

namespace glisson::experiments {

/// Straight ways along a closed surface: within a triangle a line, over an edge as if both were laid flat.
class SurfaceWalk {
 public:
  /// @pre closed; outlives this.
  explicit SurfaceWalk(const TriangleMesh& surface);
  /// @param from a point of the surface. @param direction its part in the triangle's plane counts.
  /// @return where the way of so many metres ends.
  Eigen::Vector3d walk(const ClosestPoint& from, const Eigen::Vector3d& direction, double length) const;

 private:
  const TriangleMesh& surface_;
  std::map<std::pair<int, int>, int> triangle_left_of_;  ///< of the edge from first to second
};

}  // namespace glisson::experiments
