// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/atlas/area_painter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numbers>

#include "glisson/core/statistics.h"

namespace glisson::ui {
namespace {

constexpr double kAbove = 4e-4;   // metres
constexpr double kLeast = 3e-4;   // metres: a point this close to a vertex is it
constexpr int kRing = 36;         // corners of the brush's border
constexpr double kFilled = 0.75;  // of the spacing of points that stand for the faces around them

/// The median distance of a point to its closest neighbour, metres.
double spacing(const Points& points) {
  std::vector<double> closest;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index k = 0; k < points.rows(); ++k)
      if (k != i) least = std::min(least, (points.row(k) - points.row(i)).squaredNorm());
    closest.push_back(std::sqrt(least));
  }
  return closest.size() < 2 ? 0.0 : upper_median(closest);
}

}  // namespace

AreaPainter::AreaPainter(TriangleMesh liver)
    : liver_(std::move(liver)),
      normals_(vertex_normals(liver_)),
      tree_(liver_),
      painted_(static_cast<std::size_t>(liver_.vertex_count()), 0) {}

void AreaPainter::begin(const Points& area) {
  std::fill(painted_.begin(), painted_.end(), 0);
  // Points that are this liver's vertices stand for themselves, others for what lies between them.
  bool are_vertices = true;
  std::vector<Eigen::Index> nearest;
  for (Eigen::Index i = 0; i < area.rows(); ++i) {
    Eigen::Index vertex = 0;
    const double square = (liver_.vertices.rowwise() - area.row(i)).rowwise().squaredNorm().minCoeff(&vertex);
    are_vertices = are_vertices && square < kLeast * kLeast;
    nearest.push_back(vertex);
  }
  const double radius = are_vertices ? 0.0 : kFilled * spacing(area);
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    painted_[static_cast<std::size_t>(nearest[i])] = 1;
    if (radius > 0.0) dab(liver_.vertex(static_cast<int>(nearest[i])), radius, true);
  }
}

void AreaPainter::dab(const Eigen::Vector3d& p, double radius, bool add) {
  Eigen::Index nearest = 0;
  const Eigen::VectorXd squares = (liver_.vertices.rowwise() - p.transpose()).rowwise().squaredNorm();
  squares.minCoeff(&nearest);
  const Eigen::RowVector3d outwards = normals_.row(nearest);
  for (Eigen::Index v = 0; v < squares.size(); ++v)
    if (squares[v] < radius * radius && normals_.row(v).dot(outwards) > 0.0)
      painted_[static_cast<std::size_t>(v)] = add ? 1 : 0;
}

Points AreaPainter::area() const {
  Points points(std::count(painted_.begin(), painted_.end(), 1), 3);
  Eigen::Index row = 0;
  for (std::size_t v = 0; v < painted_.size(); ++v)
    if (painted_[v] != 0) points.row(row++) = liver_.vertices.row(static_cast<Eigen::Index>(v));
  return points;
}

TriangleMesh AreaPainter::faces() const {
  TriangleMesh faces;
  std::vector<int> number(painted_.size(), -1), kept;
  std::vector<Eigen::RowVector3i> triangles;
  for (int t = 0; t < liver_.triangle_count(); ++t) {
    const Eigen::RowVector3i corners = liver_.triangles.row(t);
    if (painted_[corners[0]] == 0 || painted_[corners[1]] == 0 || painted_[corners[2]] == 0) continue;
    for (int k = 0; k < 3; ++k)
      if (number[corners[k]] < 0) {
        number[corners[k]] = static_cast<int>(kept.size());
        kept.push_back(corners[k]);
      }
    triangles.emplace_back(number[corners[0]], number[corners[1]], number[corners[2]]);
  }
  faces.vertices.resize(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t i = 0; i < kept.size(); ++i)
    faces.vertices.row(static_cast<Eigen::Index>(i)) =
        liver_.vertices.row(kept[i]) + kAbove * normals_.row(kept[i]);
  faces.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    faces.triangles.row(static_cast<Eigen::Index>(i)) = triangles[i];
  return faces;
}

Points AreaPainter::ring(const Eigen::Vector3d& p, double radius) const {
  const auto normal_at = [&](const ClosestPoint& at) {
    Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 3; ++k) normal += at.barycentric[k] * normals_.row(liver_.triangles(at.triangle, k));
    return Eigen::Vector3d(normal.normalized().transpose());
  };
  const Eigen::Vector3d outwards = normal_at(tree_.closest(p)), side = outwards.unitOrthogonal(),
                        other = outwards.cross(side);
  Points line(kRing + 1, 3);
  for (int k = 0; k <= kRing; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kRing;
    const ClosestPoint at = tree_.closest(p + radius * (std::cos(angle) * side + std::sin(angle) * other));
    line.row(k) = (at.point + 2.0 * kAbove * normal_at(at)).transpose();
  }
  return line;
}

}  // namespace glisson::ui
