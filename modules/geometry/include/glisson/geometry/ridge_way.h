// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/geometry/closest_point_tree.h"

namespace glisson {

/// Ways over a surface that keep to its ridges: the cheapest ones over its edges, of which those beside a
/// ridge are dearer. Built once for a surface; queries are const and thread-safe.
class RidgeWays {
 public:
  /// @param surface metres. @pre it has triangles
  explicit RidgeWays(const TriangleMesh& surface);

  /// The crest of the ridge near a point of the surface; the surface's closest point where there is no ridge.
  /// @param reach no farther than this, metres
  Eigen::Vector3d onto_ridge(const Eigen::Vector3d& p, double reach) const;
  /// A way on the surface from one point to another, both ends as they are. @return ordered, two rows at
  /// least; the straight line where nothing joins them.
  Points between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

 private:
  int vertex_at(const Eigen::Vector3d& p) const;
  std::vector<int> cheapest(int from, int to) const;

  TriangleMesh mesh_;
  ClosestPointTree tree_;
  std::vector<double> sharp_, dearness_;
  std::vector<std::vector<int>> neighbours_;
};

}  // namespace glisson
