// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "glisson/geometry/closest_point_tree.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"

namespace glisson::registration {

/// A model's surface while it moves, with the parts of it that points of each feature may be paired with.
/// The trees are built once and refitted. Queries are const and thread-safe; move() is not.
class MovingSurface {
 public:
  /// The anterior margin's part: triangles within `margin_radius` (metres) of the landmark polyline, at least
  /// those that carry it; the notch's likewise. A landmark that the model lacks has no part.
  explicit MovingSurface(const PatientModel& model, double margin_radius = 4e-3, double notch_radius = 6e-3);

  /// @param nodes of the model's tetrahedral mesh, N x 3, metres, any frame: queries are in that frame
  /// from now on. @pre as many rows as the mesh has nodes.
  void move(const Points& nodes);

  /// Whether points of this feature have a part of their own. The surface always has.
  bool has(Feature feature) const { return !tree(feature).empty(); }
  /// Closest point on the feature's part; on the whole surface where the model lacks the landmark.
  ClosestPoint closest(Feature feature, const Eigen::Vector3d& p) const;
  /// The notch as the landmark has it, carried by the surface; triangle -1: unknown.
  ClosestPoint notch() const;
  /// First hit of a ray with the whole surface; see ClosestPointTree::first_hit.
  ClosestPoint first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double t_min,
                         double t_max) const {
    return whole_.first_hit(origin, direction, t_min, t_max);
  }

  /// Outward unit normal at a closest point, interpolated from the vertices'.
  Eigen::Vector3d normal(const ClosestPoint& at) const;
  /// Nodes of the tetrahedral mesh behind a triangle's corners.
  std::array<int, 3> nodes(int triangle) const;
  /// The surface as it is now.
  const TriangleMesh& mesh() const { return mesh_; }
  /// Triangles of a feature's part (all for the surface), ascending.
  const std::vector<int>& triangles(Feature feature) const {
    return part_[static_cast<std::size_t>(feature) - 1];
  }

 private:
  const ClosestPointTree& tree(Feature feature) const;

  std::vector<int> node_of_vertex_;
  TriangleMesh mesh_;
  Points normals_;
  std::array<std::vector<int>, 3> part_;
  ClosestPointTree whole_, margin_, notch_;
  ClosestPoint notch_point_;  ///< triangle and weights, bound at rest
};

}  // namespace glisson::registration
