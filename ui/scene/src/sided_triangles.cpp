// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/sided_triangles.h"

#include <Eigen/Geometry>
#include <vector>

#include "glisson/geometry/topology.h"

namespace glisson::scene {
namespace {

constexpr int kRings = 8;  ///< of triangles along a vessel, beside its open end

/// Whether a triangle walks from a to b, and not from b to a.
bool walks(const TriangleMesh& mesh, int triangle, int a, int b) {
  for (int k = 0; k < 3; ++k)
    if (mesh.triangles(triangle, k) == a && mesh.triangles(triangle, (k + 1) % 3) == b) return true;
  return false;
}

/// For each vertex how its piece is wound: 1 outwards, -1 inwards, 0 open or in two ways.
std::vector<int> windings(const TriangleMesh& mesh) {
  int count = 0;
  const std::vector<int> piece = connected_components(mesh, &count);
  std::vector<double> volumes(static_cast<std::size_t>(count), 0.0);
  std::vector<bool> is_sound(volumes.size(), true);
  for (const Edge& edge : edges(mesh)) {
    const bool is_whole = edge.right >= 0 && !edge.non_manifold &&
                          walks(mesh, edge.left, edge.a, edge.b) != walks(mesh, edge.right, edge.a, edge.b);
    if (!is_whole) is_sound[static_cast<std::size_t>(piece[static_cast<std::size_t>(edge.a)])] = false;
  }
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Vector3d a = mesh.vertex(mesh.triangles(t, 0)), b = mesh.vertex(mesh.triangles(t, 1)),
                          c = mesh.vertex(mesh.triangles(t, 2));
    volumes[static_cast<std::size_t>(piece[static_cast<std::size_t>(mesh.triangles(t, 0))])] +=
        a.cross(b).dot(c);
  }
  std::vector<int> winding;
  for (const int p : piece) {
    const auto at = static_cast<std::size_t>(p);
    winding.push_back(!is_sound[at] || volumes[at] == 0.0 ? 0 : volumes[at] > 0.0 ? 1 : -1);
  }
  return winding;
}

/// Vertices that lie some rings from where these triangles are cut off, at most.
std::vector<bool> near_open_ends(const TriangleMesh& drawn) {
  std::vector<bool> near(static_cast<std::size_t>(drawn.vertex_count()), false);
  for (const Edge& edge : edges(drawn))
    if (edge.right < 0)
      near[static_cast<std::size_t>(edge.a)] = near[static_cast<std::size_t>(edge.b)] = true;
  for (int ring = 0; ring < kRings; ++ring) {
    const std::vector<bool> before = near;
    for (int t = 0; t < drawn.triangle_count(); ++t) {
      bool reached = false;
      for (int k = 0; k < 3; ++k)
        reached = reached || before[static_cast<std::size_t>(drawn.triangles(t, k))];
      for (int k = 0; reached && k < 3; ++k) near[static_cast<std::size_t>(drawn.triangles(t, k))] = true;
    }
  }
  return near;
}

}  // namespace

SidedTriangles sort_by_sides(const TriangleMesh& whole, const Triangles& kept) {
  const std::vector<int> winding = windings(whole);
  const std::vector<bool> near_end = near_open_ends({whole.vertices, kept});
  SidedTriangles sorted;
  sorted.triangles.resize(kept.rows(), 3);
  std::vector<Eigen::Index> two_sided;
  for (Eigen::Index t = 0; t < kept.rows(); ++t) {
    const int way = winding[static_cast<std::size_t>(kept(t, 0))];
    bool sees_back = way == 0;
    for (int k = 0; k < 3; ++k) sees_back = sees_back || near_end[static_cast<std::size_t>(kept(t, k))];
    if (sees_back) {
      two_sided.push_back(t);
      continue;
    }
    auto row = sorted.triangles.row(sorted.one_sided++);
    row = kept.row(t);
    if (way < 0) std::swap(row[1], row[2]);
  }
  for (std::size_t i = 0; i < two_sided.size(); ++i)
    sorted.triangles.row(sorted.one_sided + static_cast<Eigen::Index>(i)) = kept.row(two_sided[i]);
  return sorted;
}

}  // namespace glisson::scene
