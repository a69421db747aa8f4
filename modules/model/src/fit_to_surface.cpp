// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_to_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fill_dents.h"
#include "glisson/core/error.h"
#include "glisson/geometry/topology.h"
#include "worst_angle.h"

namespace glisson::model {
namespace {

constexpr int kSurfacePasses = 8, kInclusionPasses = 12;
constexpr double kMostOffset = 0.15e-3;  // metres that boundary nodes may stand out for the volume's sake
constexpr double kStuck = 0.1e-3;        // metres: a node farther from its place is stuck
constexpr int kRoomPasses = 6, kDentRounds = 4, kSliverPasses = 12;
constexpr double kEnough = 1e-6;            // metres: a node this near is in its place
constexpr double kVolumeTolerance = 0.002;  // of a sub-domain

class Fitter {
 public:
  Fitter(TetMesh& mesh, const FitTargets& targets, const ClosestPointTree& tree, const Points& normals,
         double least_dihedral_deg, const RunContext& context)
      : mesh_(mesh),
        targets_(targets),
        tree_(tree),
        normals_(normals),
        most_cosine_(std::cos(least_dihedral_deg * std::numbers::pi / 180.0)),
        context_(context),
        cells_(static_cast<std::size_t>(mesh.vertex_count())),
        on_boundary_(static_cast<std::size_t>(mesh.vertex_count()), 0) {
    for (int t = 0; t < mesh.tetrahedron_count(); ++t)
      for (int k = 0; k < 4; ++k) cells_[static_cast<std::size_t>(mesh.tetrahedra(t, k))].push_back(t);
    boundary_ = boundary_surface(mesh).node_of_vertex;
    for (const int node : boundary_) on_boundary_[static_cast<std::size_t>(node)] = 1;
  }

  void to_surface() {
    for (int pass = 0; pass < kSurfacePasses; ++pass) {
      fit_boundary(0.0);
      for (const FitTargets::Inclusion& inclusion : targets_.inclusions) fit_inclusion(inclusion);
    }
    free_stuck();
  }

  /// Cells flatter than allowed that the mesher has left: their nodes move to where the flattest cell around
  /// each is least flat (Freitag and Ollivier-Gooch, Tetrahedral mesh improvement using swapping and
  /// smoothing, 1997: smoothing of the worst angle).
  void mend_slivers() {
    for (int pass = 0; pass < kSliverPasses; ++pass) {
      bool moved = false;
      for (int cell = 0; cell < mesh_.tetrahedron_count(); ++cell) {
        if (context_.cancelled()) return;
        for (int k = 0; k < 4 && worst_of(cell) > most_cosine_; ++k)
          moved |= flatten_least(mesh_.tetrahedra(cell, k));
      }
      if (!moved) return;
    }
  }

  void to_volume() {
    double offset = 0.0;
    for (int pass = 0; pass < kSurfacePasses; ++pass) {
      if (context_.cancelled()) return;
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
      if (context_.cancelled()) return;
      const Eigen::Vector3d p = mesh_.vertex(node);
      const ClosestPoint closest = tree_.closest(p);
      move(node, closest.point + offset * normals_.row(closest.triangle).transpose() - p);
    }
  }

  /// Nodes that a cell beside them holds back: the nodes around make room, as far as their own cells can bear
  /// it.
  void free_stuck() {
    for (int pass = 0; pass < kSurfacePasses; ++pass) {
      int advanced = 0;
      for (const int node : boundary_) {
        if (context_.cancelled()) return;
        if (step_to_surface(node).norm() > kStuck) advanced += advance(node);
      }
      if (advanced == 0) return;
    }
  }

  Eigen::Vector3d step_to_surface(int node) const {
    const Eigen::Vector3d p = mesh_.vertex(node);
    return tree_.closest(p).point - p;
  }

  /// As far towards the surface as the nodes around can make room for.
  bool advance(int node) {
    const Eigen::Vector3d from = mesh_.vertex(node), step = step_to_surface(node);
    const double allowed = std::max(most_cosine_, worst_around(node));
    std::vector<int> around = neighbours_that_may_move(node);
    std::vector<Eigen::Vector3d> places;
    places.reserve(around.size());
    for (const int other : around) places.push_back(mesh_.vertex(other));
    for (const double share : {1.0, 0.6, 0.3, 0.15}) {
      mesh_.vertices.row(node) = (from + share * step).transpose();
      for (int pass = 0; pass < kRoomPasses && worst_around(node) > allowed; ++pass)
        for (const int other : around) make_room(other, node);
      if (worst_around(node) <= allowed) return true;
      for (std::size_t i = 0; i < around.size(); ++i) mesh_.vertices.row(around[i]) = places[i].transpose();
    }
    mesh_.vertices.row(node) = from.transpose();
    return false;
  }

  /// Pattern search. A node of the boundary stays on the surface. @return whether it has moved.
  bool flatten_least(int node) {
    const Eigen::Vector3d begin = mesh_.vertex(node);
    const bool boundary = on_boundary_[static_cast<std::size_t>(node)] != 0;
    const int beside = mesh_.tetrahedra(cells_[static_cast<std::size_t>(node)].front(), 0) == node ? 1 : 0;
    const double scale =
        (mesh_.vertex(mesh_.tetrahedra(cells_[static_cast<std::size_t>(node)].front(), beside)) - begin)
            .norm();
    double best = worst_around(node);
    for (const double length : {0.2, 0.1, 0.05, 0.02, 0.01})
      for (int direction = 0; direction < 6; ++direction) {
        const Eigen::Vector3d from = mesh_.vertex(node);
        Eigen::Vector3d to = from;
        to[direction / 2] += (direction % 2 == 0 ? length : -length) * scale;
        if (boundary) to = tree_.closest(to).point;
        mesh_.vertices.row(node) = to.transpose();
        const double worst = worst_around(node);
        if (worst < best)
          best = worst;
        else
          mesh_.vertices.row(node) = from.transpose();
      }
    return mesh_.vertex(node) != begin;
  }

  /// Nodes on the skin of a sub-domain stay: its volume has been fitted.
  std::vector<int> neighbours_that_may_move(int node) const {
    std::vector<int> around;
    for (const int cell : cells_[static_cast<std::size_t>(node)])
      for (int k = 0; k < 4; ++k) {
        const int other = mesh_.tetrahedra(cell, k);
        const auto& cells = cells_[static_cast<std::size_t>(other)];
        const int label = mesh_.labels[static_cast<std::size_t>(cells.front())];
        const bool skin = std::any_of(cells.begin(), cells.end(), [&](int one) {
          return mesh_.labels[static_cast<std::size_t>(one)] != label;
        });
        if (other != node && !skin) around.push_back(other);
      }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return around;
  }

  /// Moves a node to where the cells around `centre` are better; its other cells must bear it. A node of the
  /// boundary keeps its distance to the surface.
  void make_room(int node, int centre) {
    const auto& cells = cells_[static_cast<std::size_t>(node)];
    const auto worst_beside = [&] {
      double worst = -1.0;
      for (const int cell : cells)
        if (!has(cell, centre)) worst = std::max(worst, worst_of(cell));
      return worst;
    };
    const double allowed = std::max(most_cosine_, worst_beside());
    const bool boundary = on_boundary_[static_cast<std::size_t>(node)] != 0;
    const double scale = (mesh_.vertex(node) - mesh_.vertex(centre)).norm();
    const double off = boundary ? step_to_surface(node).norm() : 0.0;
    double best = worst_around(centre);
    for (const double length : {0.2, 0.05})
      for (int direction = 0; direction < 6; ++direction) {
        const Eigen::Vector3d from = mesh_.vertex(node);
        Eigen::Vector3d to = from;
        to[direction / 2] += (direction % 2 == 0 ? length : -length) * scale;
        if (boundary && off < kStuck) to = tree_.closest(to).point;
        mesh_.vertices.row(node) = to.transpose();
        const double worst = worst_around(centre);
        const bool farther = boundary && step_to_surface(node).norm() > std::max(off, kEnough);
        if (!farther && worst < best && worst_beside() <= allowed)
          best = worst;
        else
          mesh_.vertices.row(node) = from.transpose();
      }
  }

  bool has(int cell, int node) const {
    for (int k = 0; k < 4; ++k)
      if (mesh_.tetrahedra(cell, k) == node) return true;
    return false;
  }

  /// One step of all nodes between the sub-domain and the rest along the normals.
  void fit_inclusion(const FitTargets::Inclusion& inclusion) {
    if (context_.cancelled()) return;
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
      if (context_.cancelled()) return;
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
    return worst_cosine({mesh_.vertex(mesh_.tetrahedra(cell, 0)), mesh_.vertex(mesh_.tetrahedra(cell, 1)),
                         mesh_.vertex(mesh_.tetrahedra(cell, 2)), mesh_.vertex(mesh_.tetrahedra(cell, 3))});
  }

  TetMesh& mesh_;
  const FitTargets& targets_;
  const ClosestPointTree& tree_;
  const Points& normals_;
  double most_cosine_;
  const RunContext& context_;  ///< asked at every node whether to stop; then all passes come to nothing
  std::vector<std::vector<int>> cells_;  ///< around each node
  std::vector<int> boundary_;
  std::vector<char> on_boundary_;
};

/// Of what is no sub-domain to be fitted.
int body_label(const TetMesh& mesh, const FitTargets& targets) {
  for (const int label : mesh.labels)
    if (std::none_of(targets.inclusions.begin(), targets.inclusions.end(),
                     [&](const FitTargets::Inclusion& one) { return one.label == label; }))
      return label;
  return mesh.labels.front();
}

}  // namespace

bool fit_to_surface(TetMesh& mesh, const FitTargets& targets, double least_dihedral_deg,
                    const RunContext& context) {
  if (targets.surface == nullptr || targets.surface->triangle_count() == 0)
    throw PreconditionError("a mesh is fitted to a surface");
  require(targets.volume > 0.0, "a mesh is fitted to a volume");
  if (mesh.tetrahedron_count() == 0) return !context.cancelled();
  const ClosestPointTree tree(*targets.surface);
  const Points normals = triangle_normals(*targets.surface);
  const int body = body_label(mesh, targets);
  const auto fitter = [&] { return Fitter(mesh, targets, tree, normals, least_dihedral_deg, context); };
  for (int round = 0; round < kDentRounds; ++round) {
    fitter().to_surface();
    if (fill_dents(mesh, tree, normals, body, least_dihedral_deg, context) == 0) break;
  }
  fitter().mend_slivers();
  fitter().to_volume();
  return !context.cancelled();
}

}  // namespace glisson::model
