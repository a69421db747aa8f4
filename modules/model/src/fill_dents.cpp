// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill_dents.h"

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include "glisson/geometry/topology.h"
#include "worst_angle.h"

namespace glisson::model {
namespace {

constexpr double kLeastDepth = 0.3e-3;  // metres below the surface: less is no dent
constexpr double kMostAbove = 0.5e-3;   // metres that a new cell's middle may stand out
constexpr std::size_t kLongestRing = 7;

using Ring = std::vector<int>;
using Triangle = std::array<int, 3>;
using Filling = std::vector<Triangle>;

/// The ways to cut a polygon with corners first .. last (closed from last to first) into triangles.
std::vector<Filling> fillings(const Ring& ring, std::size_t first, std::size_t last) {
  if (last - first < 2) return {{}};
  std::vector<Filling> all;
  for (std::size_t middle = first + 1; middle < last; ++middle)
    for (const Filling& before : fillings(ring, first, middle))
      for (const Filling& after : fillings(ring, middle, last)) {
        Filling whole = before;
        whole.insert(whole.end(), after.begin(), after.end());
        whole.push_back({ring[first], ring[middle], ring[last]});
        all.push_back(std::move(whole));
      }
  return all;
}

class DentFiller {
 public:
  DentFiller(TetMesh& mesh, const ClosestPointTree& surface, const Points& normals, int label,
             double least_dihedral_deg)
      : mesh_(mesh),
        surface_(surface),
        normals_(normals),
        label_(label),
        most_cosine_(std::cos(least_dihedral_deg * std::numbers::pi / 180.0)) {}

  int run() {
    int covered = 0;
    for (const int node : boundary_surface(mesh_).node_of_vertex)
      if (depth(mesh_.vertex(node)) > kLeastDepth) covered += cover(node);
    return covered;
  }

 private:
  /// Metres below the surface; negative above it.
  double depth(const Eigen::Vector3d& p) const {
    const ClosestPoint closest = surface_.closest(p);
    const double side = (closest.point - p).dot(normals_.row(closest.triangle).transpose());
    return side < 0.0 ? -closest.distance : closest.distance;
  }

  bool cover(int node) {
    const std::optional<Ring> ring = ring_around(node);
    if (!ring) return false;
    double best = most_cosine_;
    std::optional<Filling> chosen;
    for (const Filling& filling : fillings(*ring, 0, ring->size() - 1)) {
      double worst = -1.0;
      for (const Triangle& triangle : filling) worst = std::max(worst, worst_cosine(corners(node, triangle)));
      if (worst > best || !fits(node, *ring, filling)) continue;
      best = worst;
      chosen = filling;
    }
    if (!chosen) return false;
    const Eigen::Index count = mesh_.tetrahedra.rows();
    mesh_.tetrahedra.conservativeResize(count + static_cast<Eigen::Index>(chosen->size()), 4);
    for (std::size_t i = 0; i < chosen->size(); ++i) {
      const auto [a, b, c] = (*chosen)[i];
      mesh_.tetrahedra.row(count + static_cast<Eigen::Index>(i)) << node, a, b, c;
      mesh_.labels.push_back(label_);
    }
    return true;
  }

  std::array<Eigen::Vector3d, 4> corners(int node, const Triangle& triangle) const {
    return {mesh_.vertex(node), mesh_.vertex(triangle[0]), mesh_.vertex(triangle[1]),
            mesh_.vertex(triangle[2])};
  }

  /// The boundary nodes around one, counter-clockwise from outside; none: they are no single ring, or a long
  /// one.
  std::optional<Ring> ring_around(int node) const {
    std::map<int, int> next;
    const BoundarySurface boundary = boundary_surface(mesh_);
    const auto number = [&](int t, int k) {
      return boundary.node_of_vertex[static_cast<std::size_t>(boundary.mesh.triangles(t, k))];
    };
    for (int t = 0; t < boundary.mesh.triangle_count(); ++t)
      for (int k = 0; k < 3; ++k)
        if (number(t, k) == node) next[number(t, (k + 1) % 3)] = number(t, (k + 2) % 3);
    if (next.size() < 3 || next.size() > kLongestRing) return {};
    Ring ring{next.begin()->first};
    while (ring.size() < next.size()) {
      const auto found = next.find(ring.back());
      if (found == next.end() || found->second == ring.front()) return {};
      ring.push_back(found->second);
    }
    const auto last = next.find(ring.back());
    if (last == next.end() || last->second != ring.front()) return {};
    return ring;
  }

  /// Whether the new cells lie in the body, beside all others, and their new edges and faces are new.
  bool fits(int node, const Ring& ring, const Filling& filling) const {
    std::set<std::pair<int, int>> sides;
    for (std::size_t i = 0; i < ring.size(); ++i)
      sides.insert(std::minmax(ring[i], ring[(i + 1) % ring.size()]));
    for (const Triangle& triangle : filling) {
      if (exists({triangle.begin(), triangle.end()})) return false;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto edge = std::minmax(triangle[k], triangle[(k + 1) % 3]);
        if (sides.count(edge) == 0 && exists({edge.first, edge.second})) return false;
      }
      const auto p = corners(node, triangle);
      const Eigen::Vector3d middle = 0.25 * (p[0] + p[1] + p[2] + p[3]), face = (p[1] + p[2] + p[3]) / 3.0;
      if (depth(middle) < -kMostAbove) return false;
      for (const double share : {0.1, 0.5, 0.9})
        if (taken(middle + share * (face - middle))) return false;
      for (std::size_t k = 1; k < 4; ++k)
        if (taken(0.9 * (0.5 * (p[k] + p[k % 3 + 1])) + 0.1 * middle)) return false;
    }
    return true;
  }

  /// Whether one cell has all these nodes.
  bool exists(const std::vector<int>& nodes) const {
    for (int t = 0; t < mesh_.tetrahedron_count(); ++t) {
      std::size_t found = 0;
      for (int k = 0; k < 4; ++k)
        for (const int node : nodes) found += mesh_.tetrahedra(t, k) == node;
      if (found == nodes.size()) return true;
    }
    return false;
  }

  /// Whether a place lies in a cell.
  bool taken(const Eigen::Vector3d& p) const {
    for (int t = 0; t < mesh_.tetrahedron_count(); ++t) {
      const Eigen::Vector3d a = mesh_.vertex(mesh_.tetrahedra(t, 0)),
                            b = mesh_.vertex(mesh_.tetrahedra(t, 1)),
                            c = mesh_.vertex(mesh_.tetrahedra(t, 2)),
                            d = mesh_.vertex(mesh_.tetrahedra(t, 3));
      if ((b - p).cross(c - p).dot(d - p) > 0.0 && (d - p).cross(c - p).dot(a - p) > 0.0 &&
          (d - p).cross(a - p).dot(b - p) > 0.0 && (a - p).cross(c - p).dot(b - p) > 0.0)
        return true;
    }
    return false;
  }

  TetMesh& mesh_;
  const ClosestPointTree& surface_;
  const Points& normals_;
  int label_;
  double most_cosine_;
};

}  // namespace

int fill_dents(TetMesh& mesh, const ClosestPointTree& surface, const Points& normals, int label,
               double least_dihedral_deg) {
  return DentFiller(mesh, surface, normals, label, least_dihedral_deg).run();
}

}  // namespace glisson::model
