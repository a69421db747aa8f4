// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/geometry/mesh.h"

namespace glisson {

/// The triangles around each vertex of a mesh, in ascending order: what a vertex's normal is made of, where
/// few of many are asked for. Holds while the vertices move. Pure queries, safe from any thread.
class VertexStars {
 public:
  VertexStars() = default;
  /// @pre indices in range.
  explicit VertexStars(const TriangleMesh& mesh);

  /// Unit normal of one vertex, weighted by angle (Thürmer and Wüthrich 1998): the bits of vertex_normals'
  /// row. Zero where nothing but flat triangles meet. @pre the mesh of the construction, its vertices moved.
  Eigen::Vector3d normal(const TriangleMesh& mesh, int vertex) const;

 private:
  std::vector<int> first_;     ///< of each vertex in triangle_; one more at the end
  std::vector<int> triangle_;  ///< vertex after vertex
};

}  // namespace glisson
