// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/vertex_stars.h"

#include <Eigen/Geometry>
#include <cmath>

namespace glisson {

VertexStars::VertexStars(const TriangleMesh& mesh)
    : first_(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0),
      triangle_(static_cast<std::size_t>(mesh.triangles.size())) {
  for (const int vertex : mesh.triangles.reshaped<Eigen::RowMajor>())
    ++first_[static_cast<std::size_t>(vertex) + 1];
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  std::vector<int> next = first_;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto vertex = static_cast<std::size_t>(mesh.triangles(t, k));
      triangle_[static_cast<std::size_t>(next[vertex]++)] = t;
    }
}

Eigen::Vector3d VertexStars::normal(const TriangleMesh& mesh, int vertex) const {
  const auto at = static_cast<std::size_t>(vertex);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = first_[at]; i < first_[at + 1]; ++i) {
    const int t = triangle_[static_cast<std::size_t>(i)];
    int k = 0;
    while (mesh.triangles(t, k) != vertex) ++k;
    const Eigen::Vector3d here = mesh.vertex(vertex);
    const Eigen::Vector3d u = mesh.vertex(mesh.triangles(t, (k + 1) % 3)) - here;
    const Eigen::Vector3d v = mesh.vertex(mesh.triangles(t, (k + 2) % 3)) - here;
    const Eigen::Vector3d across = u.cross(v);
    const double length = across.norm();
    if (length > 0.0) sum += std::atan2(length, u.dot(v)) / length * across;
  }
  const double length = sum.norm();
  return length > 0.0 ? Eigen::Vector3d(sum / length) : sum;
}

Points vertex_normals(const TriangleMesh& mesh) {
  const VertexStars stars(mesh);
  Points normals(mesh.vertex_count(), 3);
  for (int i = 0; i < mesh.vertex_count(); ++i) normals.row(i) = stars.normal(mesh, i).transpose();
  return normals;
}

}  // namespace glisson
