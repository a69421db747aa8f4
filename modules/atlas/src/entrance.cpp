// SPDX-License-Identifier: GPL-3.0-or-later
#include "entrance.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "glisson/geometry/closest_point_tree.h"

namespace glisson::atlas {
namespace {

constexpr int kRays = 48;
constexpr double kSight = 0.03;     // metres: what is farther is not around the vein
constexpr double kNear = 0.025;     // metres from the liver, farther out nothing comes in
constexpr double kBeneath = 0.004;  // metres beneath the vein's wall: about its axis
constexpr double kInside = 0.6;     // share of the rays; a vein that lies on a flat face has a half

/// Evenly over the sphere (Fibonacci's lattice).
std::vector<Eigen::Vector3d> directions() {
  std::vector<Eigen::Vector3d> all;
  for (int k = 0; k < kRays; ++k) {
    const double z = 1.0 - (2.0 * k + 1.0) / kRays, round = k * std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double r = std::sqrt(1.0 - z * z);
    all.emplace_back(r * std::cos(round), r * std::sin(round), z);
  }
  return all;
}

/// Whether a point lies in the tissue itself. @param normals of the liver's vertices
bool is_within(const TriangleMesh& liver, const Points& normals, const ClosestPointTree& tree,
               const Eigen::Vector3d& p) {
  const ClosestPoint at = tree.closest(p);
  Eigen::RowVector3d outwards = Eigen::RowVector3d::Zero();
  for (int k = 0; k < 3; ++k) outwards += at.barycentric[k] * normals.row(liver.triangles(at.triangle, k));
  return outwards.dot((p - at.point).transpose()) < 0.0;
}

/// Of each vertex of the vein whether the liver is around it.
std::vector<char> surrounded(const TriangleMesh& liver, const TriangleMesh& vein) {
  const ClosestPointTree tree(liver);
  const std::vector<Eigen::Vector3d> rays = directions();
  const Points normals = vertex_normals(vein), liver_normals = vertex_normals(liver);
  std::vector<char> inside(static_cast<std::size_t>(vein.vertex_count()), 0);
  for (int v = 0; v < vein.vertex_count(); ++v) {
    const Eigen::Vector3d from = vein.vertex(v) - kBeneath * normals.row(v).transpose();
    char& is = inside[static_cast<std::size_t>(v)];
    is = is_within(liver, liver_normals, tree, from) ? 1 : 0;
    if (is != 0 || tree.closest(from, kNear).triangle < 0) continue;
    int met = 0;
    for (const Eigen::Vector3d& ray : rays) met += tree.first_hit(from, ray, 0.0, kSight).triangle >= 0;
    is = met >= kInside * kRays ? 1 : 0;
  }
  return inside;
}

}  // namespace

Points entrance_loop(const TriangleMesh& liver, const TriangleMesh& vein) {
  const std::vector<char> inside = surrounded(liver, vein);
  std::vector<Eigen::RowVector3d> crossings;
  for (int t = 0; t < vein.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = vein.triangles(t, k), b = vein.triangles(t, (k + 1) % 3);
      // Each edge has two triangles, which run along it either way.
      if (inside[static_cast<std::size_t>(a)] == 0 || inside[static_cast<std::size_t>(b)] != 0) continue;
      crossings.emplace_back(0.5 * (vein.vertices.row(a) + vein.vertices.row(b)));
    }
  Points loop(static_cast<Eigen::Index>(crossings.size()), 3);
  for (std::size_t i = 0; i < crossings.size(); ++i) loop.row(static_cast<Eigen::Index>(i)) = crossings[i];
  return loop;
}

}  // namespace glisson::atlas
