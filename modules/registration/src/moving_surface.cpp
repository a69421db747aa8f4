// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/moving_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "glisson/core/error.h"
#include "glisson/geometry/topology.h"
#include "glisson/patient/label_map.h"

namespace glisson::registration {
namespace {

constexpr double kPolylineSpacing = 2e-3;

/// The polyline with intermediate points, so that distances to its points stand for distances to it.
Points densify(const Points& polyline) {
  std::vector<Eigen::Vector3d> dense;
  for (Eigen::Index i = 0; i < polyline.rows(); ++i) {
    dense.emplace_back(polyline.row(i).transpose());
    if (i + 1 == polyline.rows()) break;
    const Eigen::Vector3d step = (polyline.row(i + 1) - polyline.row(i)).transpose();
    const int pieces = std::max(1, static_cast<int>(std::ceil(step.norm() / kPolylineSpacing)));
    for (int k = 1; k < pieces; ++k)
      dense.emplace_back(polyline.row(i).transpose() + step * (static_cast<double>(k) / pieces));
  }
  Points points(static_cast<Eigen::Index>(dense.size()), 3);
  for (std::size_t i = 0; i < dense.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) = dense[i].transpose();
  return points;
}

/// Triangles that carry the landmark's points, and those within `radius` of them.
std::vector<int> triangles_near(const TriangleMesh& mesh, const ClosestPointTree& tree, const Points& points,
                                double radius) {
  std::vector<char> chosen(static_cast<std::size_t>(mesh.triangle_count()), 0);
  std::vector<Eigen::Vector3d> sorted;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    sorted.emplace_back(points.row(i).transpose());
    const ClosestPoint at = tree.closest(sorted.back());
    if (at.triangle >= 0) chosen[static_cast<std::size_t>(at.triangle)] = 1;
  }
  const auto before = [](const Eigen::Vector3d& p, double x) { return p.x() < x; };
  std::sort(sorted.begin(), sorted.end(),
            [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q) { return before(p, q.x()); });
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Vector3d a = mesh.vertex(mesh.triangles(t, 0)), b = mesh.vertex(mesh.triangles(t, 1)),
                          c = mesh.vertex(mesh.triangles(t, 2));
    const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c).array() - radius,
                          high = a.cwiseMax(b).cwiseMax(c).array() + radius;
    for (auto p = std::lower_bound(sorted.begin(), sorted.end(), low.x(), before);
         p != sorted.end() && p->x() <= high.x() && chosen[static_cast<std::size_t>(t)] == 0; ++p) {
      if ((p->array() < low.array()).any() || (p->array() > high.array()).any()) continue;
      const Eigen::Vector3d w = closest_on_triangle(*p, a, b, c);
      if ((w[0] * a + w[1] * b + w[2] * c - *p).norm() <= radius) chosen[static_cast<std::size_t>(t)] = 1;
    }
  }
  std::vector<int> triangles;
  for (std::size_t t = 0; t < chosen.size(); ++t)
    if (chosen[t] != 0) triangles.push_back(static_cast<int>(t));
  return triangles;
}

/// The segmented outline of the liver; null when there is none that encloses about what the mesh does.
const TriangleMesh* fine_outline(const PatientModel& model) {
  constexpr double kVolumeShare = 0.15;
  for (const NamedSurface& surface : model.surfaces) {
    if (surface.structure != structure::kParenchyma || surface.mesh.triangle_count() == 0) continue;
    const double own = std::abs(volume(surface.mesh)), meshed = std::abs(volume(model.surface.mesh));
    if (std::abs(own - meshed) < kVolumeShare * meshed) return &surface.mesh;
  }
  return nullptr;
}

/// Of each triangle; empty: all are 0.
std::vector<double> deviations_of(const TriangleMesh& mesh, const std::vector<int>& triangles,
                                  const Landmarks& landmarks) {
  std::vector<double> of_triangle;
  const Eigen::VectorXd& deviation = landmarks.margin_deviation;
  if (deviation.size() == 0 || deviation.maxCoeff() <= 0.0) return of_triangle;
  of_triangle.reserve(triangles.size());
  for (const int t : triangles)
    of_triangle.push_back(margin_deviation_at(
        landmarks, (mesh.vertices.row(mesh.triangles(t, 0)) + mesh.vertices.row(mesh.triangles(t, 1)) +
                    mesh.vertices.row(mesh.triangles(t, 2))) /
                       3.0));
  return of_triangle;
}

}  // namespace

double margin_deviation_at(const Landmarks& landmarks, const Eigen::RowVector3d& p_in_ct) {
  if (landmarks.margin_deviation.size() == 0) return 0.0;
  require(landmarks.margin_deviation.size() == landmarks.anterior_margin.rows(),
          "each point of a margin has its deviation, or none has");
  Eigen::Index nearest = 0;
  (landmarks.anterior_margin.rowwise() - p_in_ct).rowwise().squaredNorm().minCoeff(&nearest);
  return landmarks.margin_deviation[nearest];
}

MovingSurface::MovingSurface(const PatientModel& model, SurfaceDetail detail, double margin_radius,
                             double notch_radius)
    : node_of_vertex_(model.surface.node_of_vertex),
      node_count_(model.mesh.vertex_count()),
      mesh_(model.surface.mesh) {
  if (detail == SurfaceDetail::fine)
    if (const TriangleMesh* fine = fine_outline(model)) {
      mesh_ = *fine;
      node_of_vertex_.clear();
      carry_finely(model.mesh);
    }
  stars_ = VertexStars(mesh_);
  whole_ = ClosestPointTree(mesh_);
  require(mesh_.triangle_count() > 0, "a model needs a surface to be registered");
  part_[0].resize(static_cast<std::size_t>(mesh_.triangle_count()));
  std::iota(part_[0].begin(), part_[0].end(), 0);
  if (model.landmarks.anterior_margin.rows() > 0) {
    part_[1] = triangles_near(mesh_, whole_, densify(model.landmarks.anterior_margin), margin_radius);
    margin_ = ClosestPointTree(mesh_, part_[1]);
    margin_deviation_ = deviations_of(mesh_, part_[1], model.landmarks);
  }
  if (model.landmarks.umbilical_notch.rows() > 0) {
    part_[2] = triangles_near(mesh_, whole_, model.landmarks.umbilical_notch, notch_radius);
    notch_ = ClosestPointTree(mesh_, part_[2]);
    notch_deviation_ = model.landmarks.notch_deviation;
    notch_point_ = whole_.closest(model.landmarks.umbilical_notch.colwise().mean().transpose());
  }
}

void MovingSurface::carry_finely(const TetMesh& tetrahedra) {
  const Binding binding = bind_points(tetrahedra, mesh_.vertices, false);
  rest_ = mesh_.vertices;
  for (std::size_t i = 0; i < binding.tetrahedron.size(); ++i) {
    std::array<int, 4> nodes{};
    Eigen::Matrix4d corners;
    for (int k = 0; k < 4; ++k) {
      nodes[static_cast<std::size_t>(k)] = tetrahedra.tetrahedra(binding.tetrahedron[i], k);
      corners.col(k) << tetrahedra.vertices.row(nodes[static_cast<std::size_t>(k)]).transpose(), 1.0;
    }
    corners_.push_back(nodes);
    weights_.emplace_back(binding.weights.row(static_cast<Eigen::Index>(i)).transpose());
    weights_of_point_.emplace_back(corners.inverse());
  }
}

void MovingSurface::stand_still() { normals_ = vertex_normals(mesh_); }

ClosestPoint MovingSurface::notch() const {
  ClosestPoint at = notch_point_;
  if (at.triangle < 0) return at;
  at.point = place(at);
  at.distance = 0.0;
  return at;
}

void MovingSurface::move(const Points& nodes) {
  require(nodes.rows() == node_count_, "a moving surface is given all nodes of its mesh");
  for (std::size_t i = 0; i < node_of_vertex_.size(); ++i)
    mesh_.vertices.row(static_cast<Eigen::Index>(i)) = nodes.row(node_of_vertex_[i]);
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    Eigen::RowVector3d p = Eigen::RowVector3d::Zero();
    for (std::size_t k = 0; k < 4; ++k)
      p += weights_[i][static_cast<Eigen::Index>(k)] * nodes.row(corners_[i][k]);
    mesh_.vertices.row(static_cast<Eigen::Index>(i)) = p;
  }
  ++moves_;
  normals_.resize(0, 3);
  whole_.refit(mesh_.vertices);
  if (!margin_.empty()) margin_.refit(mesh_.vertices);
  if (!notch_.empty()) notch_.refit(mesh_.vertices);
}

const ClosestPointTree& MovingSurface::tree(Feature feature) const {
  return feature == Feature::anterior_margin   ? margin_
         : feature == Feature::umbilical_notch ? notch_
                                               : whole_;
}

ClosestPoint MovingSurface::closest(Feature feature, const Eigen::Vector3d& p, int near) const {
  const ClosestPointTree& part = tree(feature);
  return part.empty() ? whole_.closest_from(near, p) : part.closest_from(near, p);
}

double MovingSurface::deviation(Feature feature, const ClosestPoint& at) const {
  if (feature == Feature::umbilical_notch) return notch_deviation_;
  if (feature != Feature::anterior_margin || margin_deviation_.empty()) return 0.0;
  const auto found = std::lower_bound(part_[1].begin(), part_[1].end(), at.triangle);
  return found == part_[1].end() || *found != at.triangle
             ? 0.0
             : margin_deviation_[static_cast<std::size_t>(found - part_[1].begin())];
}

template <class NormalOfVertex>
Eigen::Vector3d MovingSurface::mixed_normal(const ClosestPoint& at, const NormalOfVertex& of_vertex) const {
  Eigen::Vector3d n = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) n += at.barycentric[k] * of_vertex(mesh_.triangles(at.triangle, k));
  const double length = n.norm();
  return length > 0.0 ? Eigen::Vector3d(n / length) : n;
}

Eigen::Vector3d MovingSurface::normal(const ClosestPoint& at) const {
  return mixed_normal(at, [this](int vertex) -> Eigen::Vector3d {
    return normals_.rows() > 0 ? normals_.row(vertex).transpose() : stars_.normal(mesh_, vertex);
  });
}

Eigen::Vector3d MovingSurface::normal(const ClosestPoint& at, NormalMemo& memo) const {
  if (memo.move != moves_) {
    const auto count = static_cast<std::size_t>(mesh_.vertex_count());
    memo.normals.resize(count);
    memo.is_known.assign(count, 0);
    memo.move = moves_;
  }
  return mixed_normal(at, [this, &memo](int vertex) -> const Eigen::Vector3d& {
    const auto i = static_cast<std::size_t>(vertex);
    if (memo.is_known[i] == 0) memo.normals[i] = stars_.normal(mesh_, vertex);
    memo.is_known[i] = 1;
    return memo.normals[i];
  });
}

Eigen::Vector3d MovingSurface::place(const ClosestPoint& at) const {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) p += at.barycentric[k] * mesh_.vertex(mesh_.triangles(at.triangle, k));
  return p;
}

Carrier MovingSurface::carrier(const ClosestPoint& at) const {
  Carrier carrier;
  const auto corner = [&](int k) { return static_cast<std::size_t>(mesh_.triangles(at.triangle, k)); };
  if (corners_.empty()) {
    for (int k = 0; k < 3; ++k) {
      carrier.nodes[static_cast<std::size_t>(k)] = node_of_vertex_[corner(k)];
      carrier.weights[static_cast<std::size_t>(k)] = at.barycentric[k];
    }
    return carrier;
  }
  // The corners may belong to three tetrahedra; the one of the nearest corner stands for all.
  int nearest = 0;
  at.barycentric.maxCoeff(&nearest);
  Eigen::Vector4d p = Eigen::Vector4d::UnitW();
  for (int k = 0; k < 3; ++k)
    p.head<3>() += at.barycentric[k] * rest_.row(static_cast<Eigen::Index>(corner(k))).transpose();
  const Eigen::Vector4d weights = weights_of_point_[corner(nearest)] * p;
  carrier.nodes = corners_[corner(nearest)];
  for (std::size_t k = 0; k < 4; ++k) carrier.weights[k] = weights[static_cast<Eigen::Index>(k)];
  return carrier;
}

}  // namespace glisson::registration
