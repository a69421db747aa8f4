// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <vector>

#include "glisson/geometry/mesh.h"

namespace glisson {

/// The closest point of a triangle mesh to a query.
struct ClosestPoint {
  int triangle = -1;  ///< -1: none within the search radius
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();  ///< weights of the triangle's vertices, sum 1
  double distance = std::numeric_limits<double>::infinity();
};

/// A bounding-volume tree over triangles, four children a node. Built once; when the vertices move it is
/// refitted in linear time, not rebuilt (registration moves the same surface hundreds of times), and while
/// they move by little its boxes stay and are taken for larger. Queries are exact, const and thread-safe.
class ClosestPointTree {
 public:
  ClosestPointTree() = default;
  /// @pre indices in range. An empty mesh gives a tree that finds nothing.
  explicit ClosestPointTree(const TriangleMesh& mesh);
  /// Only the chosen triangles of the mesh (for label-restricted pairs); results keep the mesh's triangle
  /// numbers.
  ClosestPointTree(const TriangleMesh& mesh, const std::vector<int>& triangles);

  /// The same triangles with new vertex positions. @pre same number of rows as at construction.
  void refit(const Points& vertices);

  /// @param radius nothing farther than this (metres) is returned.
  ClosestPoint closest(const Eigen::Vector3d& query,
                       double radius = std::numeric_limits<double>::infinity()) const;

  /// The same, found sooner where the answer is near: a query that has moved a little since its last answer.
  /// @param near a triangle of this tree; -1: none is known.
  ClosestPoint closest_from(int near, const Eigen::Vector3d& query) const;

  /// First hit of a ray from `origin` along `direction` (need not be a unit vector) with parameter in (t_min,
  /// t_max); distance holds the parameter. triangle = -1: none.
  ClosestPoint first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double t_min = 0.0,
                         double t_max = std::numeric_limits<double>::infinity()) const;

  bool empty() const { return nodes_.empty(); }

 private:
  /// Boxes of up to four children, rounded outwards to single precision, so that they are looked at together.
  /// It lies in two lines of the cache, which are fetched together.
  struct alignas(128) Node {
    Eigen::Array4f low[3], high[3];  ///< each axis; of an absent child empty
    int child[4];                    ///< a node, or ~k: the triangle order_[k]; kAbsent
  };
  struct Queue;
  using Corners = std::array<int, 3>;  ///< rows of vertices_
  /// Takes the triangle's closest point where it is nearer than the best so far.
  void offer(int triangle, const Corners& corners, const Eigen::Vector3d& query, double& best_squared,
             ClosestPoint& best) const;
  /// Takes the ray's point on the triangle where it is nearer than the nearest so far.
  void meet(int triangle, const Corners& corners, const Eigen::Vector3d& origin,
            const Eigen::Vector3d& direction, double t_min, double& nearest, ClosestPoint& best) const;
  ClosestPoint search(const Eigen::Vector3d& query, double best_squared, ClosestPoint best) const;
  int build(int begin, int end, const std::vector<Eigen::Vector3d>& centres);
  int split(int begin, int end, const std::vector<Eigen::Vector3d>& centres);
  void fit(Node& node) const;
  void fit_all();
  void place(const Points& vertices);

  /// In the order in which the triangles need them, so that what is near in space is near in memory.
  Points vertices_;
  std::vector<int> row_of_;          ///< of each of the mesh's vertices in vertices_
  std::vector<int> place_of_;        ///< of each of the mesh's triangles in order_; -1: it is not chosen
  std::vector<int> order_;           ///< of the triangles
  std::vector<Corners> corners_of_;  ///< of the triangles, in that order
  std::vector<Node> nodes_;
  Points fitted_;                                    ///< vertices that the boxes were fitted to
  Eigen::Vector3d slack_ = Eigen::Vector3d::Zero();  ///< by which any has moved since, at most, each axis
  double most_slack_ = 0.0;                          ///< beyond it the boxes are fitted anew
};

/// The point of triangle (a, b, c) closest to p, as barycentric weights (Ericson, Real-Time Collision
/// Detection, 5.1.5).
Eigen::Vector3d closest_on_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                    const Eigen::Vector3d& b, const Eigen::Vector3d& c);

}  // namespace glisson
