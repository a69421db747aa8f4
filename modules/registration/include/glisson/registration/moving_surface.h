// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/vertex_stars.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"

namespace glisson::registration {

/// Which surface stands for the organ. `mesh`: the boundary of the tetrahedra, nothing but their nodes.
/// `fine`: the patient's segmented surface, carried by the tetrahedra next to it: a mesh of some 550 vertices
/// cuts the sharp margin off by up to a centimetre, and a cloud cannot be matched to what is not there. Where
/// the model has no such surface, or one that is no outline of its mesh, it is the mesh's.
enum class SurfaceDetail { mesh, fine };

/// What moves a point of the surface: nodes of the tetrahedral mesh (-1: unused) and their weights, whose sum
/// is 1. Outside the mesh weights may be negative: the point moves with the extended tetrahedron.
struct Carrier {
  std::array<int, 4> nodes{-1, -1, -1, -1};
  std::array<double, 4> weights{};
};

/// How far the margin may lie from where it is at its point that is nearest to this one, metres; see
/// Landmarks.
double margin_deviation_at(const Landmarks& landmarks, const Eigen::RowVector3d& p_in_ct);

/// Vertices' normals that were asked for since a surface moved, each made once. Of one surface and one
/// thread.
struct NormalMemo {
  std::vector<Eigen::Vector3d> normals;
  std::vector<char> is_known;
  long move = -1;  ///< which one they are of
};

/// A model's surface while it moves, with the parts of it that points of each feature may be paired with.
/// The trees are built once and refitted. Queries are const and thread-safe; move() is not.
class MovingSurface {
 public:
  /// The anterior margin's part: triangles within `margin_radius` (metres) of the landmark polyline, at least
  /// those that carry it; the notch's likewise. A landmark that the model lacks has no part.
  explicit MovingSurface(const PatientModel& model, SurfaceDetail detail = SurfaceDetail::mesh,
                         double margin_radius = 4e-3, double notch_radius = 6e-3);

  /// @param nodes of the model's tetrahedral mesh, N x 3, metres, any frame: queries are in that frame
  /// from now on. @pre as many rows as the mesh has nodes.
  void move(const Points& nodes);

  /// Makes all normals at once, for queries of a surface that stays as it is until the next move().
  void stand_still();

  /// Whether points of this feature have a part of their own. The surface always has.
  bool has(Feature feature) const { return !tree(feature).empty(); }
  /// Closest point on the feature's part; on the whole surface where the model lacks the landmark.
  /// @param p in the nodes' frame.
  /// @param near the triangle of an earlier answer for this feature, which the new one is near to; -1: none.
  /// The answer is the same.
  ClosestPoint closest(Feature feature, const Eigen::Vector3d& p, int near = -1) const;
  /// The notch as the landmark has it, carried by the surface; triangle -1: unknown.
  ClosestPoint notch() const;
  /// How far a landmark may lie from where the model has it at this place, a standard deviation in metres
  /// (see Landmarks); 0: no more than a person's mark, and on the surface.
  double deviation(Feature feature, const ClosestPoint& at) const;
  /// Of each triangle of the margin's part; empty: all are 0.
  const std::vector<double>& margin_deviations() const { return margin_deviation_; }
  /// First hit of a ray (nodes' frame) with the whole surface; see ClosestPointTree::first_hit.
  ClosestPoint first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double t_min,
                         double t_max) const {
    return whole_.first_hit(origin, direction, t_min, t_max);
  }

  /// Outward unit normal at a closest point, interpolated from the vertices'.
  Eigen::Vector3d normal(const ClosestPoint& at) const;
  /// The same, for one thread that asks for many on a surface that moves on.
  Eigen::Vector3d normal(const ClosestPoint& at, NormalMemo& memo) const;
  /// Where the place of a closest-point query is now, in the nodes' frame.
  Eigen::Vector3d place(const ClosestPoint& at) const;
  /// What moves the point of a closest-point query.
  Carrier carrier(const ClosestPoint& at) const;
  /// The surface as it is now.
  const TriangleMesh& mesh() const { return mesh_; }
  /// Triangles of a feature's part (all for the surface), ascending.
  const std::vector<int>& triangles(Feature feature) const {
    return part_[static_cast<std::size_t>(feature) - 1];
  }

 private:
  const ClosestPointTree& tree(Feature feature) const;

  void carry_finely(const TetMesh& tetrahedra);
  template <class NormalOfVertex>
  Eigen::Vector3d mixed_normal(const ClosestPoint& at, const NormalOfVertex& of_vertex) const;

  std::vector<int> node_of_vertex_;  ///< of the mesh's own surface; empty for a fine one
  // Of a fine surface: the tetrahedron of each vertex (node numbers), its weights there, all at rest.
  std::vector<std::array<int, 4>> corners_;
  std::vector<Eigen::Vector4d> weights_;
  std::vector<Eigen::Matrix4d> weights_of_point_;  ///< maps (p, 1) at rest to the weights in that tetrahedron
  Points rest_;
  int node_count_ = 0;
  TriangleMesh mesh_;
  VertexStars stars_;
  long moves_ = 0;
  Points normals_;  ///< of all vertices where it stands still; else empty: few of many are asked for
  std::array<std::vector<int>, 3> part_;
  /// Of the triangles of the margin's part, in its order; may be none.
  std::vector<double> margin_deviation_;
  double notch_deviation_ = 0.0;
  ClosestPointTree whole_, margin_, notch_;
  ClosestPoint notch_point_;  ///< triangle and weights, bound at rest
};

}  // namespace glisson::registration
