// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/patient_model.h"

#include <Eigen/Dense>
#include <map>

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/patient/label_map.h"

namespace glisson {
namespace {

/// Buckets of tetrahedra by their boxes, so that a lookup visits a handful.
class TetrahedronGrid {
 public:
  explicit TetrahedronGrid(const TetMesh& mesh) : mesh_(mesh) {
    low_ = mesh.vertices.colwise().minCoeff().transpose();
    const Eigen::Vector3d extent = mesh.vertices.colwise().maxCoeff().transpose() - low_;
    cell_ = std::max(extent.maxCoeff() * 1e-3,
                     std::cbrt(extent.prod() / std::max(1, mesh.tetrahedron_count() / 4)));
    for (int k = 0; k < 3; ++k) size_[k] = static_cast<int>(extent[k] / cell_) + 1;
    buckets_.resize(static_cast<std::size_t>(size_.prod()));
    for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
      Eigen::Vector3d low = mesh.vertex(mesh.tetrahedra(t, 0)), high = low;
      for (int k = 1; k < 4; ++k) {
        low = low.cwiseMin(mesh.vertex(mesh.tetrahedra(t, k)));
        high = high.cwiseMax(mesh.vertex(mesh.tetrahedra(t, k)));
      }
      Eigen::Matrix3d edges;
      for (int k = 0; k < 3; ++k)
        edges.col(k) = mesh.vertex(mesh.tetrahedra(t, k)) - mesh.vertex(mesh.tetrahedra(t, 3));
      inverse_edges_.push_back(edges.inverse());
      const Eigen::Vector3i a = cell_of(low), b = cell_of(high);
      for (int z = a.z(); z <= b.z(); ++z)
        for (int y = a.y(); y <= b.y(); ++y)
          for (int x = a.x(); x <= b.x(); ++x) buckets_[offset({x, y, z})].push_back(t);
    }
  }

  /// Weights of a tetrahedron's corners that give p.
  Eigen::Vector4d barycentric(int t, const Eigen::Vector3d& p) const {
    const Eigen::Vector3d w =
        inverse_edges_[static_cast<std::size_t>(t)] * (p - mesh_.vertex(mesh_.tetrahedra(t, 3)));
    return {w[0], w[1], w[2], 1.0 - w.sum()};
  }

  /// The first tetrahedron that holds p, or -1.
  int find(const Eigen::Vector3d& p, Eigen::Vector4d& weights) const {
    for (const int t : buckets_[offset(cell_of(p))]) {
      weights = barycentric(t, p);
      if (weights.minCoeff() >= -1e-9) return t;
    }
    return -1;
  }

 private:
  Eigen::Vector3i cell_of(const Eigen::Vector3d& p) const {
    return ((p - low_) / cell_)
        .array()
        .floor()
        .max(-1.0)
        .min(1e6)
        .cast<int>()
        .max(0)
        .min(size_.array() - 1)
        .matrix();
  }
  std::size_t offset(const Eigen::Vector3i& c) const {
    return static_cast<std::size_t>(c.x()) +
           static_cast<std::size_t>(size_.x()) *
               (static_cast<std::size_t>(c.y()) +
                static_cast<std::size_t>(size_.y()) * static_cast<std::size_t>(c.z()));
  }

  const TetMesh& mesh_;
  Eigen::Vector3d low_;
  double cell_ = 1.0;
  Eigen::Vector3i size_;
  std::vector<std::vector<int>> buckets_;
  std::vector<Eigen::Matrix3d> inverse_edges_;
};

}  // namespace

std::vector<std::pair<Label, Eigen::Vector3d>> lesion_centres(const PatientModel& model) {
  std::map<Label, std::pair<Eigen::Vector3d, double>> sums;
  const Eigen::VectorXd volumes = tetrahedron_volumes(model.mesh);
  for (std::size_t t = 0; t < model.mesh.labels.size(); ++t) {
    const int code = model.mesh.labels[t];
    if (!is_lesion(code)) continue;
    const auto label = static_cast<Label>(code);
    auto& [sum, total] = sums.try_emplace(label, Eigen::Vector3d::Zero(), 0.0).first->second;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (int k = 0; k < 4; ++k)
      centre += 0.25 * model.mesh.vertex(model.mesh.tetrahedra(static_cast<Eigen::Index>(t), k));
    const double v = volumes[static_cast<Eigen::Index>(t)];
    sum += v * centre;
    total += v;
  }
  std::vector<std::pair<Label, Eigen::Vector3d>> centres;
  centres.reserve(sums.size());
  for (const auto& [label, sum] : sums) centres.emplace_back(label, sum.first / sum.second);
  for (const NamedSurface& surface : model.surfaces)
    if (is_lesion(surface.structure) && !sums.contains(surface.structure))
      centres.emplace_back(surface.structure, centroid(surface.mesh));
  return centres;
}

Points Binding::apply(const TetMesh& mesh, const Points& nodes) const {
  require(nodes.rows() == mesh.vertex_count(),
          "a binding is applied to the nodes of the mesh that it was made for");
  Points points = Points::Zero(weights.rows(), 3);
  for (Eigen::Index i = 0; i < weights.rows(); ++i)
    for (int k = 0; k < 4; ++k)
      points.row(i) +=
          weights(i, k) * nodes.row(mesh.tetrahedra(tetrahedron[static_cast<std::size_t>(i)], k));
  return points;
}

Binding bind_points(const TetMesh& mesh, const Points& points, bool clamp) {
  require(mesh.tetrahedron_count() > 0, "points are bound to a mesh that has tetrahedra");
  const TetrahedronGrid grid(mesh);
  Binding binding;
  binding.tetrahedron.resize(static_cast<std::size_t>(points.rows()));
  binding.weights.resize(points.rows(), 4);
  BoundarySurface surface;
  ClosestPointTree tree;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d p = points.row(i).transpose();
    Eigen::Vector4d weights;
    int t = grid.find(p, weights);
    if (t < 0) {
      if (tree.empty()) {  // only when a point is outside
        surface = boundary_surface(mesh);
        tree = ClosestPointTree(surface.mesh);
      }
      const ClosestPoint closest = tree.closest(p);
      t = surface.tetrahedron_of_triangle[static_cast<std::size_t>(closest.triangle)];
      weights = grid.barycentric(t, clamp ? closest.point : p);
      binding.outside.push_back(static_cast<int>(i));
    }
    binding.tetrahedron[static_cast<std::size_t>(i)] = t;
    binding.weights.row(i) = weights.transpose();
  }
  return binding;
}

}  // namespace glisson
