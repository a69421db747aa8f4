// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill_dents.h"

#include <algorithm>
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

/// Which cells have a node, and which may hold a place: bins of space, each with the cells whose boxes reach
/// into it. Nodes do not move meanwhile.
class CellsByPlace {
 public:
  explicit CellsByPlace(const TetMesh& mesh)
      : mesh_(mesh), of_node_(static_cast<std::size_t>(mesh.vertex_count())) {
    low_ = mesh.vertices.colwise().minCoeff().transpose();
    const Eigen::Vector3d extent = mesh.vertices.colwise().maxCoeff().transpose() - low_;
    // About one cell a bin, as far as there may be so many.
    bin_ = std::max({1e-9, std::cbrt(extent.prod() / std::max(1, mesh.tetrahedron_count())),
                     extent.maxCoeff() / kMostBins});
    size_ = (extent / bin_).array().floor().cast<int>() + 1;
    bins_.resize(static_cast<std::size_t>(size_.cast<long>().prod()));
    for (int cell = 0; cell < mesh.tetrahedron_count(); ++cell) add(cell);
  }

  /// A cell that the mesh has got since.
  void add(int cell) {
    Eigen::Vector3d low = mesh_.vertex(mesh_.tetrahedra(cell, 0)), high = low;
    for (int k = 0; k < 4; ++k) {
      const int node = mesh_.tetrahedra(cell, k);
      of_node_[static_cast<std::size_t>(node)].push_back(cell);
      low = low.cwiseMin(mesh_.vertex(node));
      high = high.cwiseMax(mesh_.vertex(node));
    }
    // A hair more than the box: rounding leaves no cell out.
    const Eigen::Vector3i from = bin_of((low.array() - kRounding).matrix()),
                          to = bin_of((high.array() + kRounding).matrix());
    for (int k = from.z(); k <= to.z(); ++k)
      for (int j = from.y(); j <= to.y(); ++j)
        for (int i = from.x(); i <= to.x(); ++i) bins_[offset({i, j, k})].push_back(cell);
  }

  const std::vector<int>& with_node(int node) const { return of_node_[static_cast<std::size_t>(node)]; }
  /// All cells that hold the place, and others.
  const std::vector<int>& about(const Eigen::Vector3d& p) const { return bins_[offset(bin_of(p))]; }

 private:
  static constexpr int kMostBins = 64;       // along an axis
  static constexpr double kRounding = 1e-9;  // metres

  Eigen::Vector3i bin_of(const Eigen::Vector3d& p) const {
    const Eigen::Array3d at = ((p - low_) / bin_).array().floor();
    return at.max(0.0).min(size_.cast<double>().array() - 1.0).cast<int>();
  }
  std::size_t offset(const Eigen::Vector3i& bin) const {
    return static_cast<std::size_t>(bin.x() + size_.x() * (bin.y() + size_.y() * bin.z()));
  }

  const TetMesh& mesh_;
  std::vector<std::vector<int>> of_node_;
  Eigen::Vector3d low_;
  double bin_ = 0.0;  ///< metres
  Eigen::Vector3i size_;
  std::vector<std::vector<int>> bins_;
};

class DentFiller {
 public:
  DentFiller(TetMesh& mesh, const ClosestPointTree& surface, const Points& normals, int label,
             double least_dihedral_deg)
      : mesh_(mesh),
        surface_(surface),
        normals_(normals),
        label_(label),
        most_cosine_(std::cos(least_dihedral_deg * std::numbers::pi / 180.0)),
        cells_(mesh) {}

  int run(const RunContext& context) {
    int covered = 0;
    for (const int node : boundary_surface(mesh_).node_of_vertex) {
      if (context.cancelled()) return covered;
      if (depth(mesh_.vertex(node)) > kLeastDepth) covered += cover(node);
    }
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
      cells_.add(static_cast<int>(count) + static_cast<int>(i));
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
    // A face with the node lies between cells with the node, or on the boundary.
    const BoundarySurface boundary = boundary_surface(part(cells_.with_node(node)));
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

  /// Some cells and all nodes.
  TetMesh part(const std::vector<int>& cells) const {
    TetMesh some;
    some.vertices = mesh_.vertices;
    some.tetrahedra.resize(static_cast<Eigen::Index>(cells.size()), 4);
    for (std::size_t i = 0; i < cells.size(); ++i)
      some.tetrahedra.row(static_cast<Eigen::Index>(i)) = mesh_.tetrahedra.row(cells[i]);
    return some;
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
    for (const int t : cells_.with_node(nodes.front())) {
      std::size_t found = 0;
      for (int k = 0; k < 4; ++k)
        for (const int node : nodes) found += mesh_.tetrahedra(t, k) == node;
      if (found == nodes.size()) return true;
    }
    return false;
  }

  /// Whether a place lies in a cell.
  bool taken(const Eigen::Vector3d& p) const {
    for (const int t : cells_.about(p)) {
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
  CellsByPlace cells_;
};

}  // namespace

int fill_dents(TetMesh& mesh, const ClosestPointTree& surface, const Points& normals, int label,
               double least_dihedral_deg, const RunContext& context) {
  return DentFiller(mesh, surface, normals, label, least_dihedral_deg).run(context);
}

}  // namespace glisson::model
