// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_to_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "glisson/core/error.h"
#include "glisson/geometry/topology.h"

namespace glisson::model {
namespace {

constexpr int kSurfacePasses = 8, kInclusionPasses = 12;
constexpr double kMostOffset = 0.15e-3;     // metres that boundary nodes may stand out for the volume's sake
constexpr double kEnough = 1e-6;            // metres: nearer is there
constexpr double kVolumeTolerance = 0.002;  // of a sub-domain

class Fitter {
 public:
  Fitter(TetMesh& mesh, const FitTargets& targets, double least_dihedral_deg)
      : mesh_(mesh),
        targets_(targets),
        tree_(*targets.surface),
        normals_(triangle_normals(*targets.surface)),
        most_cosine_(std::cos(least_dihedral_deg * std::numbers::pi / 180.0)),
        cells_(static_cast<std::size_t>(mesh.vertex_count())),
        on_boundary_(static_cast<std::size_t>(mesh.vertex_count()), 0) {
    for (int t = 0; t < mesh.tetrahedron_count(); ++t)
      for (int k = 0; k < 4; ++k) cells_[static_cast<std::size_t>(mesh.tetrahedra(t, k))].push_back(t);
    boundary_ = boundary_surface(mesh).node_of_vertex;
    for (const int node : boundary_) on_boundary_[static_cast<std::size_t>(node)] = 1;
  }

  void run() {
    for (int pass = 0; pass < kSurfacePasses; ++pass) {
      fit_boundary(0.0);
      for (const FitTargets::Inclusion& inclusion : targets_.inclusions) fit_inclusion(inclusion);
    }
    double offset = 0.0;
    for (int pass = 0; pass < kSurfacePasses; ++pass) {
      const double missing = targets_.volume - volume(mesh_);
      offset = std::clamp(offset + missing / area(boundary_surface(mesh_).mesh), -kMostOffset, kMostOffset);
      fit_boundary(offset);
    }
    for (int pass = 0; pass < kInclusionPasses; ++pass)
      for (const FitTargets::Inclusion& inclusion : targets_.inclusions) fit_inclusion(inclusion);
  }

 private:
  void fit_boundary(double offset) {
    for (const int node : boundary_) {
      const Eigen::Vector3d p = mesh_.vertex(node);
      const ClosestPoint closest = tree_.closest(p);
      move(node, closest.point + offset * normals_.row(closest.triangle).transpose() - p);
    }
  }

  /// One step of all nodes between the sub-domain and the rest along the normals.
  void fit_inclusion(const FitTargets::Inclusion& inclusion) {
    TetMesh part;
    part.vertices = mesh_.vertices;
    std::vector<int> cells;
    for (int t = 0; t < mesh_.tetrahedron_count(); ++t)
      if (mesh_.labels[static_cast<std::size_t>(t)] == inclusion.label) cells.push_back(t);
    if (cells.empty()) return;
    part.tetrahedra.resize(static_cast<Eigen::Index>(cells.size()), 4);
    for (std::size_t i = 0; i < cells.size(); ++i)
      part.tetrahedra.row(static_cast<Eigen::Index>(i)) = mesh_.tetrahedra.row(cells[i]);
    const double missing = inclusion.volume - volume(part);
    if (std::abs(missing) < kVolumeTolerance * inclusion.volume) return;
    const BoundarySurface skin = boundary_surface(part);
    const Points normals = vertex_normals(skin.mesh);
    const double step = missing / area(skin.mesh);
    for (std::size_t v = 0; v < skin.node_of_vertex.size(); ++v) {
      const int node = skin.node_of_vertex[v];
      if (on_boundary_[static_cast<std::size_t>(node)]) continue;
      move(node, step * normals.row(static_cast<Eigen::Index>(v)).transpose());
    }
  }

  /// As much of the step as the cells around the node can bear.
  void move(int node, const Eigen::Vector3d& step) {
    if (step.norm() < kEnough) return;
    const Eigen::Vector3d from = mesh_.vertex(node);
    const double allowed = std::max(most_cosine_, worst_around(node));
    for (const double share : {1.0, 0.7, 0.4, 0.2, 0.1}) {
      mesh_.vertices.row(node) = (from + share * step).transpose();
      if (worst_around(node) <= allowed) return;
    }
    mesh_.vertices.row(node) = from.transpose();
  }

  double worst_around(int node) const {
    double worst = -1.0;
    for (const int cell : cells_[static_cast<std::size_t>(node)]) worst = std::max(worst, worst_of(cell));
    return worst;
  }

  /// Cosine of a cell's smallest dihedral angle; 2 when it is flat or inside out.
  double worst_of(int cell) const {
    std::array<Eigen::Vector3d, 4> p;
    for (int k = 0; k < 4; ++k) p[static_cast<std::size_t>(k)] = mesh_.vertex(mesh_.tetrahedra(cell, k));
    if ((p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]) <= 0.0) return 2.0;
    static constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    std::array<Eigen::Vector3d, 4> n;
    for (std::size_t f = 0; f < 4; ++f) {
      const auto [a, b, c] = kFaces[f];
      n[f] = (p[static_cast<std::size_t>(b)] - p[static_cast<std::size_t>(a)])
                 .cross(p[static_cast<std::size_t>(c)] - p[static_cast<std::size_t>(a)])
                 .normalized();
    }
    double worst = -1.0;
    for (std::size_t f = 0; f < 4; ++f)
      for (std::size_t g = f + 1; g < 4; ++g) worst = std::max(worst, -n[f].dot(n[g]));
    return worst;
  }

  TetMesh& mesh_;
  const FitTargets& targets_;
  ClosestPointTree tree_;
  Points normals_;
  double most_cosine_;
  std::vector<std::vector<int>> cells_;  ///< around each node
  std::vector<int> boundary_;
  std::vector<char> on_boundary_;
};

}  // namespace

void fit_to_surface(TetMesh& mesh, const FitTargets& targets, double least_dihedral_deg) {
  require(targets.surface != nullptr && targets.surface->triangle_count() > 0,
          "a mesh is fitted to a surface");
  require(targets.volume > 0.0, "a mesh is fitted to a volume");
  if (mesh.tetrahedron_count() > 0) Fitter(mesh, targets, least_dihedral_deg).run();
}

}  // namespace glisson::model
